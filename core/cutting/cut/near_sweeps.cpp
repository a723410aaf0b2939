// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutting/cut/near_sweeps.h"

#include <algorithm>
#include <utility>

namespace proveout {

namespace {

/// A quick test before the sweep is made.
bool mayReach(const CutterMotion& motion, const PlanArea& area) {
    if (motion.cutter == nullptr)
        return false;
    const Motion& path = motion.motion;
    Box3 box;
    box.add(path.start);
    box.add(path.end);
    if (path.kind == MotionKind::arc)
        for (const Vec3& place : {path.start, path.end}) {
            const Vec3 reach(glm::distance(place, path.centre));
            box.add(path.centre - reach);
            box.add(path.centre + reach);
        }
    const Vec3 rim(motion.cutter->radius());
    box.lo -= rim;
    box.hi += rim;
    return area.meets(box);
}

} // namespace

NearSweeps::NearSweeps(const ZMapSnapshot& zmap, const IndexRect& tile, const std::vector<FallingEdge>& edges)
    : m_grid(zmap.grid()), m_topZ(zmap.stock().topZ()), m_tile(tile) {
    for (const FallingEdge& edge : edges)
        m_squares[squareOf(edge.edge)].hasEdges = true;
    for (std::size_t square = 0; square < m_squares.size(); ++square) {
        if (!m_squares[square].hasEdges)
            continue;
        const PlanArea area = areaOf(square);
        if (m_withEdges.empty())
            m_area = area;
        m_area = {glm::min(m_area.lo, area.lo), glm::max(m_area.hi, area.hi)};
        m_withEdges.push_back(square);
    }
}

PlanArea NearSweeps::areaOf(std::size_t square) const {
    const int i = m_tile.i0 + static_cast<int>(square) % kSquares * kPoints;
    const int j = m_tile.j0 + static_cast<int>(square) / kSquares * kPoints;
    return {{m_grid.x(i), m_grid.y(j)}, {m_grid.x(i + kPoints), m_grid.y(j + kPoints)}};
}

void NearSweeps::add(const CutterMotion& motion) {
    if (isFull() || !mayReach(motion, m_area))
        return;
    Sweep sweep(*motion.cutter, motion.motion, m_topZ);
    const bool isNear = !sweep.empty() && std::ranges::any_of(m_withEdges, [&](std::size_t square) {
        return areaOf(square).meets(sweep.reach());
    });
    if (isNear)
        m_sweeps.push_back(std::move(sweep));
}

void NearSweeps::sort() {
    std::ranges::sort(m_sweeps, {}, &Sweep::lowest);
}

std::vector<const Sweep*> NearSweeps::over(const RimEdge& edge, const PlanArea& area) {
    Square& square = m_squares[squareOf(edge)];
    if (!square.collected)
        collect(squareOf(edge));
    std::vector<const Sweep*> sweeps;
    for (const std::size_t k : square.sweeps)
        if (area.meets(m_sweeps[k].reach()))
            sweeps.push_back(&m_sweeps[k]);
    return sweeps;
}

void NearSweeps::collect(std::size_t square) {
    const PlanArea area = areaOf(square);
    for (std::size_t k = 0; k < m_sweeps.size(); ++k)
        if (area.meets(m_sweeps[k].reach()))
            m_squares[square].sweeps.push_back(k);
    m_squares[square].collected = true;
}

} // namespace proveout
