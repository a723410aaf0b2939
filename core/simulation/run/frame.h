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
/// any thread. Tiles, meshes and borders that did not change are the same pointers as in the frame before.
struct Frame {
    std::uint64_t generation = 0; ///< of the load or edit command this frame belongs to
    std::uint64_t sequence = 0;   ///< rises by one with each frame published
    std::uint64_t seekOver = 0;   ///< ticket of the newest seek or step that has arrived, or was given up
    std::size_t block = 0;        ///< blocks executed so far: 0 … program->blockCount()
    std::shared_ptr<const Program> program;
    std::shared_ptr<const Setup> setup;
    DecimationParameters parameters;
    ZMapSnapshot zmap;
    SurfaceSnapshot surface;
    ErrorLevel level = ErrorLevel::sample; ///< where the errors of the surface were measured
    PersistentArray<BlockStatistics>
        statistics; ///< row k: block k+1; may reach beyond `block` after a seek back
    /// Of the simulation: what is known of stock, program and tools before any block, from block 0 on; then
    /// what the blocks executed so far (beyond `block` after a seek back) have shown, in their order.
    Diagnostics findings;
    Vec3 cutterPosition{0};
    bool cutterKnown = false;
    int tool = 0;
    bool toolAssumed = false; ///< no block called it: ToolChoice assumes that it is in the spindle
    double removedMm3 = 0;    ///< since the uncut stock
    bool playing = false;
    /// Which part of its speed playback keeps, in (0, 1]; below 1 the stock lags behind the clock.
    double keptSpeed = 1;
    /// What stopped the run here; null where nothing did, or the user has gone on since.
    std::shared_ptr<const BreakpointHit> stoppedBy;
};
using FramePtr = std::shared_ptr<const Frame>;

} // namespace proveout
