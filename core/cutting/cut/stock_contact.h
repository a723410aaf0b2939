// SPDX-License-Identifier: GPL-3.0-or-later
// Where a tool that does not cut meets the stock.
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/base/geometry.h"
#include "core/cutter/cutter.h"
#include "core/nc/program/motion.h"
#include "core/zmap/stock_shape.h"

namespace proveout {

struct PastCut {
    Motion motion;
    const Cutter* cutter = nullptr;
};
/// All motions that may have cut within a box in plan; more of them do no harm.
using CutsWithin = std::function<std::vector<PastCut>(const Vec2& lo, const Vec2& hi)>;

/// The stock as the motions have left it, asked for itself rather than for its z-map: walls and edges stand
/// where they were cut and do not depend on a spacing. Keeps references; one thread.
class StockContact {
public:
    /// How exact both answers are along the way, in mm.
    static constexpr double kTolerance = 2e-3;

    /// `uncut`: the top of what of the box is stock; null: all of it is.
    StockContact(const StockBox& stock, CutsWithin cuts, std::stop_token stop,
                 const StockTop* uncut = nullptr)
        : m_stock(stock), m_cuts(std::move(cuts)), m_stop(std::move(stop)), m_uncut(uncut) {}

    /// The first time in [0, 1] on the straight way of a cutter's tip at which it touches the stock; nothing
    /// where it never does, or when stopped. Shank and holder are not looked at. As in a z-map material
    /// reaches down to the floor of the stock, and where the floor is reached nothing is left.
    [[nodiscard]] std::optional<double> firstTouch(const Cutter& cutter, const Vec3& start,
                                                   const Vec3& end) const;
    /// The first time from which on it does not touch the stock for a while: 0 where it begins free. Nothing
    /// where it touches it all the way, or when stopped.
    [[nodiscard]] std::optional<double> firstFree(const Cutter& cutter, const Vec3& start,
                                                  const Vec3& end) const;

private:
    const StockBox& m_stock;
    CutsWithin m_cuts;
    std::stop_token m_stop;
    const StockTop* m_uncut;
};

} // namespace proveout
