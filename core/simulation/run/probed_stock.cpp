// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run/probed_stock.h"

#include <algorithm>
#include <cmath>

#include "core/base/memory.h"
#include "core/simulation/setup/tool_choice.h"

namespace proveout {

namespace {

constexpr double kLeastSquare = 8;   ///< mm
constexpr double kMostSquares = 256; ///< along a side

/// A smaller distance counts as touching: the tool cannot be closer to the stock that it was stopped by.
constexpr double kTouch = 1e-3;

double squareSize(const StockBox& stock) {
    return std::max(kLeastSquare, std::max(stock.width, stock.depth) / kMostSquares);
}

std::size_t squaresAlong(double length, double size) {
    return static_cast<std::size_t>(std::max(1.0, std::ceil(length / size)));
}

} // namespace

namespace {

class StockToProbe final : public ProbedPart {
public:
    explicit StockToProbe(const Setup& setup) : m_setup(std::make_shared<const Setup>(setup)) {}

    [[nodiscard]] std::unique_ptr<ProbeTarget> target() const override {
        return std::make_unique<ProbedStock>(m_setup);
    }
    [[nodiscard]] bool sameAs(const ProbedPart& other) const override {
        const auto* stock = dynamic_cast<const StockToProbe*>(&other);
        return stock != nullptr && stock->m_setup->stock == m_setup->stock &&
               stock->m_setup->shape == m_setup->shape && stock->m_setup->tools == m_setup->tools &&
               stock->m_setup->startTool == m_setup->startTool;
    }

private:
    std::shared_ptr<const Setup> m_setup;
};

} // namespace

PartToProbe partToProbe(const Setup& setup) {
    return {std::make_shared<const StockToProbe>(setup)};
}

ProbedStock::ProbedStock(std::shared_ptr<const Setup> setup)
    : m_setup(std::move(setup)), m_size(squareSize(m_setup->stock)),
      m_columns(squaresAlong(m_setup->stock.width, m_size)) {}

const StockTop* ProbedStock::uncut(const Grid& grid) {
    const StockShape& shape = m_setup->shape;
    // Results of probing a mesh, or saved stock, have always been those of its map.
    const bool isMap = shape.kind == StockKind::mesh || shape.kind == StockKind::saved;
    if (m_uncut == nullptr && shape.body != nullptr)
        m_uncut = (isMap ? mapTopOf : topOf)(m_setup->stock, shape, grid);
    return m_uncut.get();
}

const Cutter* ProbedStock::cutterOf(const Program& program, const Motion& motion) const {
    const int number = motion.tool == 0 ? assumedTool(program, *m_setup).value_or(0) : motion.tool;
    return m_setup->tools.find(number);
}

ProbedStock::Range ProbedStock::squaresUnder(const Vec2& lo, const Vec2& hi) const {
    const StockBox& stock = m_setup->stock;
    const std::size_t rows = m_squares.size() / m_columns;
    const auto first = [&](double at, double corner) {
        return static_cast<std::size_t>(std::max(0.0, std::floor((at - corner) / m_size)));
    };
    const auto last = [&](double at, double corner, std::size_t count) {
        const double end = std::floor((at - corner) / m_size) + 1;
        return static_cast<std::size_t>(std::clamp(end, 0.0, static_cast<double>(count)));
    };
    return {first(lo.x, stock.corner.x), first(lo.y, stock.corner.y), last(hi.x, stock.corner.x, m_columns),
            last(hi.y, stock.corner.y, rows)};
}

void ProbedStock::addGroup(const Program& program, std::size_t end) {
    if (m_squares.empty())
        m_squares.resize(m_columns * squaresAlong(m_setup->stock.depth, m_size));
    for (; m_taken < end; ++m_taken) {
        const Motion motion = program.motion(m_taken);
        const Cutter* cutter = cutterOf(program, motion);
        if (cutter == nullptr || motion.probing || !motion.known() || !withinLimits(motion))
            continue;
        const Box3 box = bounds(motion);
        if (!(box.lo.z < m_setup->stock.topZ()))
            continue;
        const Range range = squaresUnder(Vec2(box.lo) - cutter->radius(), Vec2(box.hi) + cutter->radius());
        for (std::size_t j = range.j0; j < range.j1; ++j)
            for (std::size_t i = range.i0; i < range.i1; ++i)
                m_squares[j * m_columns + i].push_back(static_cast<std::uint32_t>(m_taken));
    }
}

std::vector<PastCut> ProbedStock::cutsWithin(const Program& program, const Vec2& lo, const Vec2& hi) const {
    const Range range = squaresUnder(lo, hi);
    std::vector<std::uint32_t> motions;
    for (std::size_t j = range.j0; j < range.j1; ++j)
        for (std::size_t i = range.i0; i < range.i1; ++i) {
            const Square& square = m_squares[j * m_columns + i];
            motions.insert(motions.end(), square.begin(), square.end());
        }
    std::ranges::sort(motions);
    motions.erase(std::unique(motions.begin(), motions.end()), motions.end());
    std::vector<PastCut> cuts;
    for (const std::uint32_t index : motions) {
        const Motion motion = program.motion(index);
        const Cutter* cutter = cutterOf(program, motion);
        const Box3 box = bounds(motion);
        const double radius = cutter->radius();
        if (box.lo.x - radius <= hi.x && box.hi.x + radius >= lo.x && box.lo.y - radius <= hi.y &&
            box.hi.y + radius >= lo.y)
            cuts.push_back({motion, cutter});
    }
    return cuts;
}

std::optional<StockContact> ProbedStock::stockAfter(const Program& program, std::size_t end,
                                                    const WorkContext& context) {
    const Result<Grid> grid = makeGrid(m_setup->stock, m_setup->spacing);
    const auto limit = static_cast<double>(memoryLimitBytes());
    if (!grid || !checkMemory(m_setup->stock, *grid, limit))
        return std::nullopt; // the simulation reports why
    addGroup(program, end);
    return std::optional<StockContact>(
        std::in_place, m_setup->stock,
        [&](const Vec2& lo, const Vec2& hi) { return cutsWithin(program, lo, hi); }, context.stop,
        uncut(*grid));
}

ProbeTarget::Answer ProbedStock::probe(const Program& program, const Motion& motion, Seek seek,
                                       const WorkContext& context) {
    const Cutter* cutter = cutterOf(program, motion);
    if (cutter == nullptr)
        return {};
    const auto stock = stockAfter(program, program.motionCount(), context);
    if (!stock)
        return {};
    return seek == Seek::contact ? contact(*stock, *cutter, motion) : release(*stock, *cutter, motion);
}

std::optional<Vec3> ProbedStock::firstTouch(const Program& program, std::size_t index, const Vec3& start,
                                            const Vec3& end, const WorkContext& context) {
    const Cutter* cutter = cutterOf(program, program.motion(index));
    const auto stock = cutter == nullptr ? std::nullopt : stockAfter(program, index, context);
    const auto time = stock ? stock->firstTouch(*cutter, start, end) : std::nullopt;
    return time ? std::optional(start + (end - start) * *time) : std::nullopt;
}

ProbeTarget::Answer ProbedStock::contact(const StockContact& stock, const Cutter& cutter,
                                         const Motion& motion) const {
    const auto time = stock.firstTouch(cutter, motion.start, motion.end);
    const double way = time.value_or(1) * glm::distance(motion.start, motion.end);
    if ((time && way <= kTouch) || stock.firstTouch(cutter, motion.start, motion.start - Vec3(0, 0, kTouch)))
        return {Answer::Kind::already, motion.start};
    if (!time)
        return {Answer::Kind::missed, motion.end};
    return {Answer::Kind::found, motion.start + (motion.end - motion.start) * *time};
}

/// A tool that was stopped by the stock touches it within rounding, so the path begins before its start by
/// the distance that counts as touching.
ProbeTarget::Answer ProbedStock::release(const StockContact& stock, const Cutter& cutter,
                                         const Motion& motion) const {
    const double length = glm::distance(motion.start, motion.end);
    const Vec3 along = (motion.end - motion.start) / length;
    const auto time = stock.firstFree(cutter, motion.start - along * kTouch, motion.end);
    if (!time)
        return {Answer::Kind::missed, motion.end};
    if (*time == 0)
        return {Answer::Kind::already, motion.start};
    const double way = std::max(0.0, *time * (length + kTouch) - kTouch);
    return {Answer::Kind::found, motion.start + along * way};
}

} // namespace proveout
