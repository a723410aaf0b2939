// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/lattice/lattice_triangulation.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>

namespace proveout {

namespace {

/// Positive if d is inside the circle through a, b, c (counter-clockwise), 0 on it. Coordinates are below 2⁹,
/// products below 2³⁸: exact.
std::int64_t inCircle(const PatchVertex& a, const PatchVertex& b, const PatchVertex& c,
                      const PatchVertex& d) {
    const std::int64_t ai = a.i - d.i, aj = a.j - d.j;
    const std::int64_t bi = b.i - d.i, bj = b.j - d.j;
    const std::int64_t ci = c.i - d.i, cj = c.j - d.j;
    return (ai * ai + aj * aj) * (bi * cj - bj * ci) + (bi * bi + bj * bj) * (ci * aj - cj * ai) +
           (ci * ci + cj * cj) * (ai * bj - aj * bi);
}

} // namespace

void LatticeTriangulation::reset(const RegionPatch& patch) {
    const std::int32_t east = patch.width() - 1;
    const std::int32_t north = patch.height() - 1;
    m_parity = patch.parity();
    m_vertices.clear();
    m_edgeFrom.clear();
    m_triangles.clear();
    for (const auto& [i, j] : {std::array{0, 0}, {east, 0}, {east, north}, {0, north}})
        addVertex({i, j, patch.at(i, j)});
    addTriangle();
    addTriangle();
    // The diagonal of a region with one cell is the canonical one.
    if (m_parity == 0) {
        write(0, {0, 1, 2}, {kNone, kNone, 4});
        write(1, {0, 2, 3}, {2, kNone, kNone});
    } else {
        write(0, {0, 1, 3}, {kNone, 6, kNone});
        write(1, {1, 2, 3}, {kNone, kNone, 1});
    }
}

void LatticeTriangulation::assign(std::span<const PatchVertex> vertices,
                                  std::span<const std::array<std::int32_t, 3>> triangles) {
    m_vertices.assign(vertices.begin(), vertices.end());
    m_edgeFrom.assign(vertices.size(), kNone);
    m_triangles.clear();
    m_halfEdges.clear();
    for (const std::array<std::int32_t, 3>& corners : triangles) {
        const std::int32_t t = addTriangle();
        write(t, corners, {kNone, kNone, kNone});
        for (std::int32_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(corners[static_cast<std::size_t>(k)],
                                                 corners[static_cast<std::size_t>((k + 1) % 3)]);
            m_halfEdges.push_back({low, high, 4 * t + k});
        }
    }
    std::sort(m_halfEdges.begin(), m_halfEdges.end(), [](const HalfEdge& a, const HalfEdge& b) {
        return std::tie(a.low, a.high, a.edge) < std::tie(b.low, b.high, b.edge);
    });
    for (std::size_t k = 1; k < m_halfEdges.size(); ++k)
        if (m_halfEdges[k].low == m_halfEdges[k - 1].low && m_halfEdges[k].high == m_halfEdges[k - 1].high)
            link(m_halfEdges[k].edge, m_halfEdges[k - 1].edge);
}

std::int32_t LatticeTriangulation::addVertex(const PatchVertex& point) {
    m_vertices.push_back(point);
    m_edgeFrom.push_back(kNone);
    return static_cast<std::int32_t>(m_vertices.size()) - 1;
}

std::int32_t LatticeTriangulation::addTriangle() {
    m_triangles.push_back({{kNone, kNone, kNone}, 0, {kNone, kNone, kNone}, 0});
    return static_cast<std::int32_t>(m_triangles.size()) - 1;
}

void LatticeTriangulation::link(std::int32_t edge, std::int32_t twin) {
    if (edge != kNone)
        triangle(edge >> 2).twin[static_cast<std::size_t>(edge & 3)] = twin;
    if (twin != kNone)
        triangle(twin >> 2).twin[static_cast<std::size_t>(twin & 3)] = edge;
}

void LatticeTriangulation::write(std::int32_t t, const std::array<std::int32_t, 3>& vertex,
                                 const std::array<std::int32_t, 3>& twin) {
    triangle(t).vertex = vertex;
    for (std::int32_t k = 0; k < 3; ++k) {
        const auto at = static_cast<std::size_t>(k);
        m_edgeFrom[static_cast<std::size_t>(vertex[at])] = 4 * t + k;
        link(4 * t + k, twin[at]);
    }
}

std::int32_t LatticeTriangulation::insert(std::int32_t t, const PatchVertex& point,
                                          std::vector<std::int32_t>& touched) {
    const std::int32_t p = addVertex(point);
    const Triangle old = triangle(t);
    std::size_t on = 3; // index of the edge that contains the point
    for (std::size_t k = 0; k < 3; ++k)
        if (twiceArea(vertex(old.vertex[k]), vertex(old.vertex[(k + 1) % 3]), point) == 0)
            on = k;
    m_suspects.clear();
    if (on == 3) {
        const std::int32_t t1 = addTriangle();
        const std::int32_t t2 = addTriangle();
        const auto [a, b, c] = old.vertex;
        write(t, {a, b, p}, {old.twin[0], 4 * t1 + 2, 4 * t2 + 1});
        write(t1, {b, c, p}, {old.twin[1], 4 * t2 + 2, 4 * t + 1});
        write(t2, {c, a, p}, {old.twin[2], 4 * t + 2, 4 * t1 + 1});
        m_suspects = {4 * t, 4 * t1, 4 * t2};
        touched.insert(touched.end(), {t, t1, t2});
    } else {
        const std::int32_t a = old.vertex[on];
        const std::int32_t b = old.vertex[(on + 1) % 3];
        const std::int32_t c = old.vertex[(on + 2) % 3];
        const std::int32_t across = old.twin[on];
        const std::int32_t t1 = addTriangle();
        // (c, a, p) and (b, c, p): the edges to check are their edges 0.
        write(t, {c, a, p}, {old.twin[(on + 2) % 3], kNone, 4 * t1 + 1});
        write(t1, {b, c, p}, {old.twin[(on + 1) % 3], 4 * t + 2, kNone});
        m_suspects = {4 * t, 4 * t1};
        touched.insert(touched.end(), {t, t1});
        if (across != kNone) {
            const std::int32_t u = triangleOf(across);
            const std::int32_t beforeTwin = twin(next(across));
            const std::int32_t afterTwin = twin(previous(across));
            const std::int32_t d = origin(previous(across));
            const std::int32_t u1 = addTriangle();
            write(u, {a, d, p}, {beforeTwin, 4 * u1 + 2, 4 * t + 1});
            write(u1, {d, b, p}, {afterTwin, 4 * t1 + 2, 4 * u + 1});
            m_suspects.insert(m_suspects.end(), {4 * u, 4 * u1});
            touched.insert(touched.end(), {u, u1});
        }
    }
    restoreDelaunay(touched);
    return p;
}

bool LatticeTriangulation::isToFlip(std::int32_t edge) const {
    const std::int32_t other = twin(edge);
    if (other == kNone)
        return false;
    const PatchVertex& a = vertex(origin(edge));
    const PatchVertex& b = vertex(origin(next(edge)));
    const PatchVertex& c = vertex(origin(previous(edge)));
    const PatchVertex& d = vertex(origin(previous(other)));
    const std::int64_t inside = inCircle(a, b, c, d);
    if (inside != 0)
        return inside > 0;
    // Four points on a circle: either diagonal is Delaunay. That of a cell must be the canonical one.
    const bool isCell = std::abs(a.i - b.i) == 1 && std::abs(a.j - b.j) == 1 && std::abs(c.i - d.i) == 1 &&
                        std::abs(c.j - d.j) == 1;
    return isCell && ((a.i + a.j + m_parity) & 1) != 0;
}

void LatticeTriangulation::flip(std::int32_t edge) {
    const std::int32_t other = twin(edge);
    const std::int32_t t = triangleOf(edge);
    const std::int32_t u = triangleOf(other);
    const std::int32_t a = origin(edge);
    const std::int32_t b = origin(other);
    const std::int32_t c = origin(previous(edge));
    const std::int32_t d = origin(previous(other));
    const std::int32_t bc = twin(next(edge));
    const std::int32_t ca = twin(previous(edge));
    const std::int32_t ad = twin(next(other));
    const std::int32_t db = twin(previous(other));
    write(t, {a, d, c}, {ad, 4 * u + 2, ca});
    write(u, {d, b, c}, {db, bc, 4 * t + 1});
}

void LatticeTriangulation::restoreDelaunay(std::vector<std::int32_t>& touched) {
    // A suspect's triangle has the new vertex opposite the edge; after the flip so have both triangles, at
    // their edges 0.
    while (!m_suspects.empty()) {
        const std::int32_t edge = m_suspects.back();
        m_suspects.pop_back();
        if (!isToFlip(edge))
            continue;
        const std::int32_t t = triangleOf(edge);
        const std::int32_t u = triangleOf(twin(edge));
        flip(edge);
        touched.push_back(u);
        m_suspects.push_back(4 * t);
        m_suspects.push_back(4 * u);
    }
}

std::int32_t LatticeTriangulation::locate(std::int32_t start, std::int32_t i, std::int32_t j) const {
    const PatchVertex point{i, j, 0};
    std::int32_t t = start;
    for (;;) {
        std::int32_t beyond = kNone;
        for (std::int32_t k = 0; k < 3 && beyond == kNone; ++k) {
            const std::int32_t edge = 4 * t + k;
            if (twiceArea(vertex(origin(edge)), vertex(origin(next(edge))), point) < 0)
                beyond = twin(edge);
        }
        if (beyond == kNone)
            return t;
        t = triangleOf(beyond);
    }
}

std::int32_t LatticeTriangulation::outlineFrom(std::int32_t v) const {
    std::int32_t edge = edgeFrom(v);
    while (twin(edge) != kNone)
        edge = next(twin(edge));
    return edge;
}

std::int32_t LatticeTriangulation::outlineTo(std::int32_t v) const {
    std::int32_t edge = previous(edgeFrom(v));
    while (twin(edge) != kNone)
        edge = previous(twin(edge));
    return edge;
}

} // namespace proveout
