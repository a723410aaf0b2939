// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/cutting/cut/stock_contact.h"
#include "core/nc/program/probe_target.h"
#include "core/simulation/setup/setup.h"

namespace proveout {

/// The stock of a setup as probing motions touch it: cut by all earlier motions that the simulation would cut
/// with, by the same cutters. Does nothing before the first probing motion; keeps four bytes for each square
/// of the plan that a motion reaches. The probing tool is its cutter of the tool table, as a rigid shape.
class ProbedStock final : public ProbeTarget {
public:
    explicit ProbedStock(std::shared_ptr<const Setup> setup);

    [[nodiscard]] Answer probe(const Program& program, const Motion& motion, Seek seek,
                               const WorkContext& context) override;

    /// The place on a straight path where the tip of the cutter of motion `index` first touches the stock
    /// left by the earlier motions; nothing if it does not, or when stopped. Indices come in ascending order.
    [[nodiscard]] std::optional<Vec3> firstTouch(const Program& program, std::size_t index, const Vec3& start,
                                                 const Vec3& end, const WorkContext& context);

private:
    using Square = std::vector<std::uint32_t>; ///< the motions that reach it

    [[nodiscard]] const Cutter* cutterOf(const Program& program, const Motion& motion) const;
    /// Adds the motions before the `end`-th.
    void addGroup(const Program& program, std::size_t end);
    /// The stock before motion `end`; nothing if there cannot be one.
    [[nodiscard]] std::optional<StockContact> stockAfter(const Program& program, std::size_t end,
                                                         const WorkContext& context);
    /// Indices of the squares under a range in plan, clipped to the stock.
    struct Range {
        std::size_t i0, j0, i1, j1; ///< half open
    };
    [[nodiscard]] Range squaresUnder(const Vec2& lo, const Vec2& hi) const;
    [[nodiscard]] std::vector<PastCut> cutsWithin(const Program& program, const Vec2& lo,
                                                  const Vec2& hi) const;
    [[nodiscard]] Answer contact(const StockContact& stock, const Cutter& cutter, const Motion& motion) const;
    [[nodiscard]] Answer release(const StockContact& stock, const Cutter& cutter, const Motion& motion) const;

    /// The top of a shape that is not a box.
    [[nodiscard]] const StockTop* uncut(const Grid& grid);

    std::shared_ptr<const Setup> m_setup;
    std::unique_ptr<StockTop> m_uncut; ///< from the first probing motion on
    double m_size;                     ///< side of a square, mm
    std::size_t m_columns;
    std::vector<Square> m_squares;
    std::size_t m_taken = 0; ///< motions
};

/// The part that the programs of a setup probe: equal if stock and cutters are equal.
[[nodiscard]] PartToProbe partToProbe(const Setup& setup);

} // namespace proveout
