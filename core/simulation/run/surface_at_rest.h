// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "core/base/work_context.h"
#include "core/decimation/surface/refined_surface.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// The better picture that is shown while nothing is cut, where there is memory for it. Owned by one thread.
class SurfaceAtRest {
public:
    /// Makes the picture of a moment. `faces` has the surface of the schedule, which tells what memory this
    /// one needs. A stopped context leaves it undone.
    void follow(ZMapSnapshot now, const DecimationParameters& parameters, std::size_t faces,
                const WorkContext& context);
    /// The z-map is another now.
    void outdate();

    [[nodiscard]] bool isShown() const { return m_isShown; }
    /// Whether it is neither there nor known not to fit.
    [[nodiscard]] bool isWanted() const { return m_fits && !m_isShown; }
    /// Where it is shown.
    [[nodiscard]] const SurfaceSnapshot& snapshot() const { return m_surface.snapshot(); }

private:
    RefinedSurface m_surface;
    std::optional<ZMapSnapshot> m_zmap; ///< that it follows
    double m_bytes = 0;                 ///< what it takes
    bool m_isShown = false;
    bool m_fits = true; ///< false: there is no memory for it now
};

} // namespace proveout
