// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "core/base/diagnostic.h"
#include "core/base/work_context.h"
#include "core/decimation/regions/parameters.h"
#include "core/decimation/surface/map_memory.h"
#include "core/decimation/surface/surface.h"
#include "core/simulation/setup/setup.h"
#include "core/zmap/stock.h"

namespace proveout {

/// Watches the memory of a surface that is decimated while it is cut. How many triangles it has is known only
/// once they are made, and machined parts need a tenth of what noise needs; so the worst case need not fit in
/// advance. What other work of the process takes, such as an export, is not the surface's fault: it is given
/// up only if its own triangles need more than is allowed. Owned by one thread.
class SurfaceMemory {
public:
    /// How much the map and everything made of it may take in addition to what the process takes now.
    void allow(std::uint64_t bytes);
    /// A new surface begins. If any surface with these parameters is allowed, nothing is watched.
    void begin(const Setup& setup, const Grid& grid, const DecimationParameters& parameters);

    /// Does work on regions of `surface` with so many points, with a context that is stopped when the memory
    /// is used up as well. Returns false if it was: the surface must be given up, and no more work is done
    /// until another begins.
    [[nodiscard]] bool limit(const Surface& surface, std::size_t points, const WorkContext& context,
                             const std::function<void(const WorkContext&)>& work);

    /// Whether there may be a surface that is too large.
    [[nodiscard]] bool isWatched() const { return m_worst > static_cast<double>(m_allowed); }
    /// Whether the surface needs more than is allowed.
    [[nodiscard]] bool exceeded() const { return m_exceeded; }
    /// The finding about that, with a spacing that would fit.
    [[nodiscard]] Diagnostic finding(const Setup& setup, const DecimationParameters& parameters) const;

private:
    std::uint64_t m_allowed = UINT64_MAX;
    std::uint64_t m_most = UINT64_MAX; ///< resident
    Grid m_grid;
    MapOutputs m_outputs;
    double m_worst = 0;
    std::size_t m_unseen = 0; ///< points since the memory was looked at
    bool m_exceeded = false;
};

} // namespace proveout
