// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/certified/greedy_insertion.h"

#include <cassert>

namespace proveout {

namespace {
constexpr std::uint32_t kOnStack = 1;
constexpr std::uint32_t kOnEdges = 2;
} // namespace

bool GreedyInsertion::run(const RegionPatch& patch,
                          const std::array<std::span<const std::uint32_t>, 4>& borders, float limit,
                          bool surface, LatticeTriangulation& mesh, const std::stop_token& stop) {
    mesh.reset(patch);
    m_stack.clear();
    m_edges.clear();
    m_extras.clear();
    m_touched.clear();
    m_width = static_cast<std::size_t>(patch.width());
    m_taken.assign(m_width * static_cast<std::size_t>(patch.height()), 0);
    for (std::int32_t v = 0; v < 4; ++v)
        occupied(mesh.vertex(v).i, mesh.vertex(v).j) = 1;
    insertBorders(patch, borders, mesh);
    insertWalls(patch, mesh);
    m_touched.clear();
    for (std::size_t t = mesh.triangleSlots(); t-- > 0;)
        m_touched.push_back(static_cast<std::int32_t>(t));
    pushTouched(mesh);
    do {
        if (!refineSamples(patch, limit, mesh, stop))
            return false;
    } while (surface && refineEdges(patch, limit, mesh));
    return true;
}

bool GreedyInsertion::refineSamples(const RegionPatch& patch, float limit, LatticeTriangulation& mesh,
                                    const std::stop_token& stop) {
    while (!m_stack.empty()) {
        const std::int32_t t = m_stack.back();
        m_stack.pop_back();
        LatticeTriangulation::Triangle& triangle = mesh.triangle(t);
        triangle.state &= ~kOnStack;
        const PatchDistance worst =
            farthestPoint(patch, mesh.vertex(triangle.vertex[0]), mesh.vertex(triangle.vertex[1]),
                          mesh.vertex(triangle.vertex[2]), limit);
        triangle.distance = worst.distance;
        if (worst.distance <= limit)
            continue;
        if (stop.stop_requested())
            return false;
        insertPoint(patch, t, worst.i, worst.j, mesh);
    }
    return true;
}

/// Checks the edges of all triangles touched since the last call; false if none exceeds the limit.
bool GreedyInsertion::refineEdges(const RegionPatch& patch, float limit, LatticeTriangulation& mesh) {
    bool found = false;
    while (!m_edges.empty() && !found) {
        const std::int32_t t = m_edges.back();
        m_edges.pop_back();
        mesh.triangle(t).state &= ~kOnEdges;
        for (std::int32_t k = 0; k < 3 && !found; ++k) {
            const std::int32_t edge = 4 * t + k;
            const std::int32_t other = mesh.twin(edge);
            // An edge between two waiting triangles is checked once, from the triangle that comes last.
            if (other == LatticeTriangulation::kNone ||
                (mesh.triangle(LatticeTriangulation::triangleOf(other)).state & kOnEdges) != 0)
                continue;
            const SurfaceCrossing crossing =
                farthestCrossing(patch, mesh.vertex(mesh.origin(edge)),
                                 mesh.vertex(mesh.origin(LatticeTriangulation::next(edge))));
            if (crossing.distance <= limit)
                continue;
            found = true;
            // The point may be elsewhere, and the other edges of this triangle still have to be checked.
            mesh.triangle(t).state |= kOnEdges;
            m_edges.push_back(t);
            insertAtCrossing(patch, t, crossing, limit, mesh);
        }
    }
    return found;
}

/// One end of the crossed edge is not a vertex yet: if both were, a unit edge would be Delaunay, and the
/// diagonal of a cell is chosen to be canonical.
void GreedyInsertion::insertAtCrossing(const RegionPatch& patch, std::int32_t t,
                                       const SurfaceCrossing& crossing, float limit,
                                       LatticeTriangulation& mesh) {
    const auto isInside = [&](std::int32_t i, std::int32_t j) {
        return i > 0 && j > 0 && i < patch.width() - 1 && j < patch.height() - 1;
    };
    const bool isNearFree = occupied(crossing.nearI, crossing.nearJ) == 0;
    const bool isFarFree = occupied(crossing.farI, crossing.farJ) == 0;
    const bool prefersFar = isFarFree && (!isNearFree || (!isInside(crossing.nearI, crossing.nearJ) &&
                                                          isInside(crossing.farI, crossing.farJ)));
    const std::int32_t i = prefersFar ? crossing.farI : crossing.nearI;
    const std::int32_t j = prefersFar ? crossing.farJ : crossing.nearJ;
    assert(isNearFree || isFarFree);
    if (isInside(i, j))
        insertPoint(patch, mesh.locate(t, i, j), i, j, mesh);
    else
        insertExtra(patch, mesh.locate(t, i, j), i, j, limit, mesh);
}

/// Inserts a point of a side, and others on both sides of it where the two new chords need them.
void GreedyInsertion::insertExtra(const RegionPatch& patch, std::int32_t t, std::int32_t i, std::int32_t j,
                                  float limit, LatticeTriangulation& mesh) {
    const std::int32_t p = insertPoint(patch, t, i, j, mesh);
    m_extras.push_back(p);
    for (const bool isAhead : {true, false}) {
        for (;;) {
            const std::int32_t edge = isAhead ? mesh.outlineFrom(p) : mesh.outlineTo(p);
            const PatchDistance worst =
                farthestBorderPoint(patch, mesh.vertex(mesh.origin(edge)),
                                    mesh.vertex(mesh.origin(LatticeTriangulation::next(edge))));
            if (worst.distance <= limit)
                break;
            insertExtra(patch, LatticeTriangulation::triangleOf(edge), worst.i, worst.j, limit, mesh);
        }
    }
}

std::int32_t GreedyInsertion::insertPoint(const RegionPatch& patch, std::int32_t t, std::int32_t i,
                                          std::int32_t j, LatticeTriangulation& mesh) {
    occupied(i, j) = 1;
    const std::int32_t p = mesh.insert(t, {i, j, patch.at(i, j)}, m_touched);
    pushTouched(mesh);
    return p;
}

/// Before any triangle is checked; the point is searched for from the vertex `before`.
std::int32_t GreedyInsertion::insertFrom(const RegionPatch& patch, std::int32_t before, std::int32_t i,
                                         std::int32_t j, LatticeTriangulation& mesh) {
    m_touched.clear();
    occupied(i, j) = 1;
    const std::int32_t t = mesh.locate(LatticeTriangulation::triangleOf(mesh.edgeFrom(before)), i, j);
    return mesh.insert(t, {i, j, patch.at(i, j)}, m_touched);
}

void GreedyInsertion::insertBorders(const RegionPatch& patch,
                                    const std::array<std::span<const std::uint32_t>, 4>& borders,
                                    LatticeTriangulation& mesh) {
    const std::int32_t east = patch.width() - 1;
    const std::int32_t north = patch.height() - 1;
    for (const Side side : kSides) {
        const std::span<const std::uint32_t> kept = borders[static_cast<std::size_t>(side)];
        std::int32_t before = side == Side::north ? 3 : side == Side::east ? 1 : 0;
        for (std::size_t k = 1; k + 1 < kept.size(); ++k) {
            const auto along = static_cast<std::int32_t>(kept[k]);
            const bool alongX = side == Side::south || side == Side::north;
            const std::int32_t i = alongX ? along : side == Side::east ? east : 0;
            const std::int32_t j = !alongX ? along : side == Side::north ? north : 0;
            before = insertFrom(patch, before, i, j, mesh);
        }
    }
}

/// All of them at once: the edges between neighbours are then edges of the mesh.
void GreedyInsertion::insertWalls(const RegionPatch& patch, LatticeTriangulation& mesh) {
    std::int32_t before = 0;
    for (const std::uint32_t offset : patch.walls()) {
        const auto i = static_cast<std::int32_t>(offset % m_width);
        const auto j = static_cast<std::int32_t>(offset / m_width);
        if (occupied(i, j) != 0)
            continue;
        before = insertFrom(patch, before, i, j, mesh);
    }
}

void GreedyInsertion::pushTouched(LatticeTriangulation& mesh) {
    for (const std::int32_t t : m_touched) {
        std::uint32_t& state = mesh.triangle(t).state;
        if ((state & kOnStack) == 0)
            m_stack.push_back(t);
        if ((state & kOnEdges) == 0)
            m_edges.push_back(t);
        state |= kOnStack | kOnEdges;
    }
    m_touched.clear();
}

} // namespace proveout
