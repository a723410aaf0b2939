// SPDX-License-Identifier: GPL-3.0-or-later
// Where a tool that does not cut touches the stock.
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
/// All motions that may have cut within a box in plan; extra ones do no harm.
using CutsWithin = std::function<std::vector<PastCut>(const Vec2& lo, const Vec2& hi)>;

/// The stock exactly as the motions have left it, rather than its z-map: walls and edges are where they were
/// cut and do not depend on a grid spacing. Keeps references; one thread.
class StockContact {
public:
    /// The accuracy of both results along the path, in mm.
    static constexpr double kTolerance = 2e-3;

    /// `uncut`: the top of the stock within the box; null: the whole box is stock.
    StockContact(const StockBox& stock, CutsWithin cuts, std::stop_token stop,
                 const StockTop* uncut = nullptr)
        : m_stock(stock), m_cuts(std::move(cuts)), m_stop(std::move(stop)), m_uncut(uncut) {}

    /// The first time in [0, 1] on the straight path of a cutter's tip at which it touches the stock; nothing
    /// if it never does, or when stopped. Shank and holder are ignored. As in a z-map, material extends down
    /// to the floor of the stock, and where a cut has reached the floor nothing is left.
    [[nodiscard]] std::optional<double> firstTouch(const Cutter& cutter, const Vec3& start,
                                                   const Vec3& end) const;
    /// The first time from which on it does not touch the stock for a while: 0 if it begins free. Nothing if
    /// it touches all the way, or when stopped.
    [[nodiscard]] std::optional<double> firstFree(const Cutter& cutter, const Vec3& start,
                                                  const Vec3& end) const;

private:
    const StockBox& m_stock;
    CutsWithin m_cuts;
    std::stop_token m_stop;
    const StockTop* m_uncut;
};

} // namespace proveout
