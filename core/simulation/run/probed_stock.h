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

/// The stock of a set-up as probing motions meet it: cut by all motions before that the simulation would cut
/// with, by the same cutters. Does nothing before the first probing motion; keeps four bytes for each square
/// of the plan that a motion reaches. The tool that probes is its cutter of the tool table, a shape that does
/// not give way.
class ProbedStock final : public ProbeTarget {
public:
    explicit ProbedStock(std::shared_ptr<const Setup> setup);

    [[nodiscard]] Answer probe(const Program& program, const Motion& motion, Seek seek,
                               const WorkContext& context) override;

    /// Where on a straight way the tip of the cutter of motion `index` first touches what the motions before
    /// that one have left; nothing where it does not, or when stopped. Indices come in ascending order.
    [[nodiscard]] std::optional<Vec3> firstTouch(const Program& program, std::size_t index, const Vec3& start,
                                                 const Vec3& end, const WorkContext& context);

private:
    using Square = std::vector<std::uint32_t>; ///< the motions that reach it

    [[nodiscard]] const Cutter* cutterOf(const Program& program, const Motion& motion) const;
    /// The motions before the `end`-th.
    void addGroup(const Program& program, std::size_t end);
    /// The stock as it is known; nothing where there can be none.
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

    /// Of a shape that is no box.
    [[nodiscard]] const StockTop* uncut(const Grid& grid);

    std::shared_ptr<const Setup> m_setup;
    std::unique_ptr<StockTop> m_uncut; ///< from the first probing motion on
    double m_size;                     ///< of a square, mm
    std::size_t m_columns;
    std::vector<Square> m_squares;
    std::size_t m_taken = 0; ///< motions
};

/// The part that the programs of a set-up probe: the same where stock and cutters are.
[[nodiscard]] PartToProbe partToProbe(const Setup& setup);

} // namespace proveout
