// SPDX-License-Identifier: GPL-3.0-or-later
// Edges and facets are sorted by their lowest vertex, those of one vertex by their other vertices, so that
// equal ones become neighbours.
#include "core/formats/mesh_defects.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace proveout {

namespace {

/// A mesh in which more than one of this many edges is open may be a sheet, whose volume has no sign.
constexpr std::size_t kMostlyClosed = 10;

using Triangle = std::array<std::uint32_t, 3>;

/// The two other vertices of a facet, the lower one first.
using OtherVertices = std::array<std::uint32_t, 2>;

/// An edge at its lower vertex: the other vertex, and in the last bit whether the facet runs towards it.
using EdgeEnd = std::uint32_t;

EdgeEnd endOf(std::uint32_t from, std::uint32_t to) {
    return std::max(from, to) * 2 + (from < to ? 1 : 0);
}

/// Values grouped by a key of 0 … keys−1. Filled in two passes over the same values, each by `each(add)`.
template<class Value, class Each>
class Buckets {
public:
    Buckets(std::size_t keys, const Each& each) : m_ends(keys + 1, 0) {
        each([this](std::size_t key, const Value&) { ++m_ends[key + 1]; });
        std::partial_sum(m_ends.begin(), m_ends.end(), m_ends.begin());
        m_values.resize(m_ends.back());
        std::vector<std::uint32_t> next(m_ends.begin(), m_ends.end() - 1);
        each([&](std::size_t key, const Value& value) { m_values[next[key]++] = value; });
    }

    /// Calls `look` with each run of values that have one key and are equal by `same`.
    template<class Same, class Look>
    void forRuns(const Same& same, const Look& look) {
        for (std::size_t key = 0; key + 1 < m_ends.size(); ++key) {
            const auto bucket = std::span(m_values).subspan(m_ends[key], m_ends[key + 1] - m_ends[key]);
            std::ranges::sort(bucket);
            for (std::size_t first = 0; first < bucket.size();) {
                std::size_t last = first + 1;
                while (last < bucket.size() && same(bucket[first], bucket[last]))
                    ++last;
                look(bucket.subspan(first, last - first));
                first = last;
            }
        }
    }

private:
    std::vector<std::uint32_t> m_ends; ///< of the bucket before
    std::vector<Value> m_values;
};

/// Counts the edges with defects; returns the number of all edges.
std::size_t countEdges(const TriangleMesh& mesh, MeshDefects& defects) {
    const auto each = [&mesh](const auto& add) {
        for (const Triangle& t : mesh.triangles)
            for (std::size_t k = 0; k < 3; ++k)
                add(std::min(t[k], t[(k + 1) % 3]), endOf(t[k], t[(k + 1) % 3]));
    };
    std::size_t edges = 0;
    Buckets<EdgeEnd, decltype(each)>(mesh.vertices.size(), each)
        .forRuns([](EdgeEnd a, EdgeEnd b) { return a / 2 == b / 2; },
                 [&](std::span<const EdgeEnd> facets) {
                     ++edges;
                     defects.openEdges += facets.size() == 1 ? 1 : 0;
                     defects.nonManifoldEdges += facets.size() > 2 ? 1 : 0;
                     defects.flippedEdges += facets.size() == 2 && facets[0] == facets[1] ? 1 : 0;
                 });
    return edges;
}

std::size_t countDuplicates(const TriangleMesh& mesh) {
    const auto each = [&mesh](const auto& add) {
        for (Triangle t : mesh.triangles) {
            std::ranges::sort(t);
            add(t[0], OtherVertices{t[1], t[2]});
        }
    };
    std::size_t duplicates = 0;
    Buckets<OtherVertices, decltype(each)>(mesh.vertices.size(), each)
        .forRuns(std::equal_to<>(),
                 [&duplicates](std::span<const OtherVertices> facets) { duplicates += facets.size() - 1; });
    return duplicates;
}

/// Six times the volume, computed relative to the first vertex: near the mesh, wherever the mesh is.
double signedVolume(const TriangleMesh& mesh) {
    double volume = 0;
    for (const Triangle& t : mesh.triangles) {
        const Vec3& origin = mesh.vertices.front();
        volume += glm::dot(mesh.vertices[t[0]] - origin,
                           glm::cross(mesh.vertices[t[1]] - origin, mesh.vertices[t[2]] - origin));
    }
    return volume;
}

} // namespace

MeshDefects findDefects(const TriangleMesh& mesh) {
    MeshDefects defects;
    const std::size_t edges = countEdges(mesh, defects);
    defects.duplicateFacets = countDuplicates(mesh);
    defects.insideOut =
        (defects.openEdges + defects.flippedEdges) * kMostlyClosed < edges && signedVolume(mesh) < 0;
    return defects;
}

} // namespace proveout
