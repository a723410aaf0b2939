// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "core/base/work_context.h"
#include "core/decimation/surface/refined_surface.h"
#include "core/simulation/run/rim_finder.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// The refined surface that is shown while nothing is cut, if there is memory for it. Owned by one thread.
class SurfaceAtRest {
public:
    /// Makes the refined surface for a moment, with its walls, which `rims` finds. `faces` is the number of
    /// faces of the scheduled surface, from which the memory is estimated. A stopped context leaves it
    /// unfinished.
    void follow(const Frame& moment, RimFinder& rims, std::size_t faces, const WorkContext& context);
    /// Call it when the z-map has changed.
    void outdate();

    [[nodiscard]] bool isShown() const { return m_isShown; }
    /// Whether it still has to be made: it does not exist yet and is not known to exceed the memory.
    [[nodiscard]] bool isWanted() const { return m_fits && !m_isShown; }
    /// Valid while it is shown.
    [[nodiscard]] const SurfaceSnapshot& snapshot() const { return m_surface.snapshot(); }
    /// What it was made from, with walls; the same.
    [[nodiscard]] const ZMapSnapshot& zmap() const { return *m_zmap; }

private:
    RefinedSurface m_surface;
    std::optional<ZMapSnapshot> m_zmap; ///< the z-map that it follows
    double m_bytes = 0;                 ///< the memory it needs
    bool m_isShown = false;
    bool m_fits = true; ///< false: there is not enough memory for it now
};

} // namespace proveout
