// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/base/work_context.h"
#include "core/simulation/run/frame.h"
#include "core/simulation/run/motion_index.h"
#include "core/simulation/setup/tool_choice.h"
#include "core/zmap/stock_shape.h"

namespace proveout {

/// The stock of a moment as the motions leave it, without a grid. Refers to the frame. Any thread.
class SweptStock {
public:
    /// Sorts the motions before the moment by the tiles of its map. If it was stopped, nothing is known.
    explicit SweptStock(const Frame& moment, const WorkContext& context = {});

    /// Whether there is material at each place (program coordinates), to 2 µm. Places beside the map have
    /// none. Evaluates the motions near each place, in parallel; if it was stopped, some are wrong.
    [[nodiscard]] std::vector<bool> isMaterial(std::span<const Vec3> places,
                                               const WorkContext& context = {}) const;

private:
    [[nodiscard]] bool isUncut(const Vec3& place) const;

    const Frame& m_moment;
    ToolChoice m_tools;
    std::unique_ptr<const StockTop> m_uncut; ///< null: the whole box
    MotionIndex m_index;
};

} // namespace proveout
