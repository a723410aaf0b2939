// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/lattice/vertex_removal.h"

#include <algorithm>
#include <cmath>

#include "core/decimation/lattice/edge_crossings.h"

namespace proveout {

namespace {
constexpr std::int32_t kUntried = -1;
constexpr std::int32_t kImpossible = -2;
} // namespace

bool VertexRemoval::run(const RegionPatch& patch, float limit, bool surface,
                        std::span<const std::int32_t> extras, LatticeTriangulation& mesh,
                        const std::stop_token& stop) {
    begin(patch, limit, surface, mesh);
    for (const std::int32_t v : extras)
        m_state[static_cast<std::size_t>(v)] = State::idle;
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v)
        push(static_cast<std::int32_t>(v));
    return drain(stop);
}

bool VertexRemoval::runFrom(const RegionPatch& patch, float limit, bool surface,
                            std::span<const std::int32_t> seeds, const std::array<bool, 4>& freeSides,
                            LatticeTriangulation& mesh, const std::stop_token& stop) {
    begin(patch, limit, surface, mesh);
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
        const PatchVertex& p = mesh.vertex(static_cast<std::int32_t>(v));
        const std::array<bool, 4> isOn{p.j == 0, p.j == patch.height() - 1, p.i == 0,
                                       p.i == patch.width() - 1};
        for (std::size_t side = 0; side < isOn.size(); ++side)
            if (isOn[side] && freeSides[side] && !patch.isWall(p.i, p.j) &&
                std::count(isOn.begin(), isOn.end(), true) == 1)
                m_state[v] = State::idle;
    }
    for (const std::int32_t v : seeds)
        push(v);
    return drain(stop);
}

/// Prepares a run with an empty queue; vertices of the outline and beside walls are not removable.
void VertexRemoval::begin(const RegionPatch& patch, float limit, bool surface, LatticeTriangulation& mesh) {
    m_surface = surface;
    m_patch = &patch;
    m_mesh = &mesh;
    m_limit = limit;
    m_queue.clear();
    m_state.assign(mesh.vertexCount(), State::idle);
    for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
        const PatchVertex& p = mesh.vertex(static_cast<std::int32_t>(v));
        if (p.i == 0 || p.j == 0 || p.i == patch.width() - 1 || p.j == patch.height() - 1 ||
            patch.isWall(p.i, p.j))
            m_state[v] = State::fixed;
    }
}

bool VertexRemoval::drain(const std::stop_token& stop) {
    std::size_t taken = 0;
    while (taken < m_queue.size()) { // the queue grows during the loop
        if (stop.stop_requested())
            return false;
        const std::int32_t v = m_queue[taken++];
        m_state[static_cast<std::size_t>(v)] = State::idle;
        if (!tryRemove(v))
            continue;
        m_state[static_cast<std::size_t>(v)] = State::removed;
        for (std::int32_t k = 0; k < m_count; ++k)
            push(m_ring[static_cast<std::size_t>(k)].vertex);
    }
    return true;
}

void VertexRemoval::push(std::int32_t vertex) {
    State& state = m_state[static_cast<std::size_t>(vertex)];
    if (state != State::idle)
        return;
    state = State::queued;
    m_queue.push_back(vertex);
}

bool VertexRemoval::tryRemove(std::int32_t vertex) {
    if (!gatherStar(vertex))
        return false;
    const auto last = static_cast<std::size_t>(m_count - 1);
    const bool mayGo = m_isClosed
                           ? holdsAtCentre()
                           : farthestBorderPoint(*m_patch, m_ring[0].at, m_ring[last].at).distance <= m_limit;
    if (!mayGo)
        return false;
    for (std::int32_t a = 0; a < m_count; ++a)
        for (std::int32_t b = a + 1; b < m_count; ++b)
            m_chord[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)].apex = kUntried;
    if (!triangulate(0, m_count - 1))
        return false;
    std::int32_t slot = 0;
    writeTriangles(0, m_count - 1, slot);
    m_mesh->kill(m_ring[static_cast<std::size_t>(slot)].triangle);
    if (m_isClosed)
        m_mesh->kill(m_ring[static_cast<std::size_t>(slot + 1)].triangle);
    return true;
}

bool VertexRemoval::gatherStar(std::int32_t vertex) {
    m_count = 0;
    const PatchVertex& centre = m_mesh->vertex(vertex);
    const std::int32_t east = m_patch->width() - 1;
    const std::int32_t north = m_patch->height() - 1;
    m_centreZ = centre.z;
    m_isClosed = centre.i > 0 && centre.j > 0 && centre.i < east && centre.j < north;
    const std::int32_t first = m_isClosed ? m_mesh->edgeFrom(vertex) : m_mesh->outlineFrom(vertex);
    std::int32_t edge = first;
    do {
        if (m_count + 1 >= kMostNeighbours)
            return false;
        const std::int32_t rim = LatticeTriangulation::next(edge);
        const std::int32_t other = m_mesh->origin(rim);
        m_ring[static_cast<std::size_t>(m_count++)] = {
            m_mesh->vertex(other), other, LatticeTriangulation::triangleOf(edge), m_mesh->twin(rim)};
        const std::int32_t back = LatticeTriangulation::previous(edge);
        edge = m_mesh->twin(back);
        if (edge == LatticeTriangulation::kNone) {
            const std::int32_t last = m_mesh->origin(back);
            m_ring[static_cast<std::size_t>(m_count++)] = {m_mesh->vertex(last), last, -1,
                                                           LatticeTriangulation::kNone};
        }
    } while (edge != first && edge != LatticeTriangulation::kNone);
    for (std::int32_t a = 0; a < m_count; ++a) {
        for (std::int32_t b = 0; b < a; ++b) {
            const auto ka = static_cast<std::size_t>(a);
            const auto kb = static_cast<std::size_t>(b);
            const std::int32_t turn = twiceArea(centre, m_ring[ka].at, m_ring[kb].at);
            m_turn[ka][kb] = turn;
            m_turn[kb][ka] = -turn;
        }
    }
    return true;
}

std::int32_t VertexRemoval::area(std::int32_t a, std::int32_t b, std::int32_t c) const {
    const auto ka = static_cast<std::size_t>(a);
    const auto kb = static_cast<std::size_t>(b);
    const auto kc = static_cast<std::size_t>(c);
    return m_turn[ka][kb] + m_turn[kb][kc] + m_turn[kc][ka];
}

/// Whether a triangle covers the vertex to be removed and is too far from it.
bool VertexRemoval::missesCentre(std::int32_t a, std::int32_t b, std::int32_t c) const {
    const auto ka = static_cast<std::size_t>(a);
    const auto kb = static_cast<std::size_t>(b);
    const auto kc = static_cast<std::size_t>(c);
    const std::int32_t wa = m_turn[kb][kc];
    const std::int32_t wb = m_turn[kc][ka];
    const std::int32_t wc = m_turn[ka][kb];
    if (wa < 0 || wb < 0 || wc < 0)
        return false;
    const float weight = static_cast<float>(wa + wb + wc);
    const float sum = static_cast<float>(wa) * m_ring[ka].at.z + static_cast<float>(wb) * m_ring[kb].at.z +
                      static_cast<float>(wc) * m_ring[kc].at.z;
    return std::abs(sum - m_centreZ * weight) > m_limit * weight;
}

/// Whether some triangle of three neighbours that covers the vertex comes near enough to it: one of them must
/// be part of the new triangulation, and most vertices fail here.
bool VertexRemoval::holdsAtCentre() const {
    for (std::int32_t a = 0; a < m_count; ++a) {
        for (std::int32_t b = a + 1; b < m_count; ++b) {
            if (m_turn[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)] < 0)
                continue;
            for (std::int32_t c = b + 1; c < m_count; ++c) {
                const bool covers = m_turn[static_cast<std::size_t>(b)][static_cast<std::size_t>(c)] >= 0 &&
                                    m_turn[static_cast<std::size_t>(c)][static_cast<std::size_t>(a)] >= 0;
                if (covers && area(a, b, c) > 0 && !missesCentre(a, b, c))
                    return true;
            }
        }
    }
    return false;
}

/// Whether the part of the hole between neighbours `from` and `to` and the chord that joins them can be
/// triangulated; memorized per chord.
bool VertexRemoval::triangulate(std::int32_t from, std::int32_t to) {
    if (to == from + 1)
        return true;
    Chord& chord = m_chord[static_cast<std::size_t>(from)][static_cast<std::size_t>(to)];
    if (chord.apex != kUntried)
        return chord.apex != kImpossible;
    chord.apex = kImpossible;
    const bool isOutline = from == 0 && to == m_count - 1;
    if (m_surface && !isOutline &&
        !crossingsWithin(*m_patch, m_ring[static_cast<std::size_t>(from)].at,
                         m_ring[static_cast<std::size_t>(to)].at, m_limit))
        return false;
    for (std::int32_t apex = from + 1; apex < to; ++apex) {
        if (area(from, apex, to) <= 0 || (m_isClosed && missesCentre(from, apex, to)))
            continue;
        const float distance = distanceUpTo(*m_patch, m_ring[static_cast<std::size_t>(from)].at,
                                            m_ring[static_cast<std::size_t>(apex)].at,
                                            m_ring[static_cast<std::size_t>(to)].at, m_limit);
        if (distance > m_limit || !triangulate(from, apex) || !triangulate(apex, to))
            continue;
        chord = {apex, distance};
        return true;
    }
    return false;
}

/// Writes the triangles of a part into the slots of the old ones; returns the edge along the chord, seen from
/// the outside: it becomes the twin of the triangle beyond it.
std::int32_t VertexRemoval::writeTriangles(std::int32_t from, std::int32_t to, std::int32_t& slot) {
    if (to == from + 1)
        return m_ring[static_cast<std::size_t>(from)].outside;
    const Chord& chord = m_chord[static_cast<std::size_t>(from)][static_cast<std::size_t>(to)];
    const std::int32_t left = writeTriangles(from, chord.apex, slot);
    const std::int32_t right = writeTriangles(chord.apex, to, slot);
    const bool isWhole = from == 0 && to == m_count - 1;
    const std::int32_t t = m_ring[static_cast<std::size_t>(slot++)].triangle;
    m_mesh->write(t,
                  {m_ring[static_cast<std::size_t>(from)].vertex,
                   m_ring[static_cast<std::size_t>(chord.apex)].vertex,
                   m_ring[static_cast<std::size_t>(to)].vertex},
                  {left, right, isWhole ? m_ring[static_cast<std::size_t>(to)].outside : -1});
    m_mesh->triangle(t).distance = chord.distance;
    return 4 * t + 2;
}

} // namespace proveout
