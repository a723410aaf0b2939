// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "core/base/diagnostic.h"
#include "core/base/persistent_array.h"
#include "core/decimation/surface/surface.h"
#include "core/nc/program/program.h"
#include "core/simulation/run/statistics.h"
#include "core/simulation/setup/setup.h"
#include "core/zmap/zmap.h"

namespace proveout {

struct BreakpointHit;

/// Everything a viewer shows of one moment of a simulation. Immutable, published as shared_ptr<const Frame>,
/// any thread. Tiles, meshes and borders that did not change are the same pointers as in the previous frame.
struct Frame {
    std::uint64_t generation = 0; ///< of the load or edit command that this frame belongs to
    std::uint64_t sequence = 0;   ///< rises by one with each frame published
    std::uint64_t seekOver = 0;   ///< ticket of the newest seek or step that has been completed or given up
    std::size_t block = 0;        ///< number of blocks executed: 0 … program->blockCount()
    std::shared_ptr<const Program> program;
    std::shared_ptr<const Setup> setup;
    DecimationParameters parameters;
    ZMapSnapshot zmap;
    SurfaceSnapshot surface;
    ErrorLevel level = ErrorLevel::sample; ///< where the errors of the surface were measured
    PersistentArray<BlockStatistics>
        statistics; ///< row k: block k+1; may extend beyond `block` after a seek back
    /// Findings of the simulation: what is known about stock, program and tools before any block, already
    /// at block 0; then the findings of the executed blocks (also beyond `block` after a seek back), in
    /// order.
    Diagnostics findings;
    Vec3 cutterPosition{0};
    bool cutterKnown = false;
    int tool = 0;
    bool toolAssumed = false; ///< no block called it: ToolChoice assumes that it is in the spindle
    double removedMm3 = 0;    ///< since the uncut stock
    bool playing = false;
    bool atRest = false; ///< the surface is as good as it gets: no frame follows without a command
    /// The fraction of its speed that playback achieves, in (0, 1]; below 1 the stock lags behind the clock.
    double keptSpeed = 1;
    /// What stopped the run here; null if nothing did, or if the user has continued since.
    std::shared_ptr<const BreakpointHit> stoppedBy;
};
using FramePtr = std::shared_ptr<const Frame>;

} // namespace proveout
