// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/decimation/closed_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

namespace proveout::test {

namespace {

using Triangle = std::array<std::uint32_t, 3>;
using Rounded = std::array<float, 3>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

Rounded rounded(const Vec3& point) {
    return {static_cast<float>(point.x), static_cast<float>(point.y), static_cast<float>(point.z)};
}

std::string say(const char* what, const Triangle& triangle) {
    std::ostringstream out;
    out << what << ": triangle " << triangle[0] << ' ' << triangle[1] << ' ' << triangle[2];
    return out.str();
}

using Normal = std::array<long double, 3>;

/// The vector of twice the area, from coordinates of any type.
template<class Point>
Normal normalOf(const Point& a, const Point& b, const Point& c) {
    Normal u{};
    Normal v{};
    for (int k = 0; k < 3; ++k) {
        const auto at = static_cast<std::size_t>(k);
        u[at] = static_cast<long double>(b[k]) - a[k];
        v[at] = static_cast<long double>(c[k]) - a[k];
    }
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

std::string wrongTriangle(const TriangleMesh& mesh) {
    for (const Triangle& triangle : mesh.triangles) {
        for (const auto vertex : triangle) {
            if (vertex >= mesh.vertices.size())
                return say("no such vertex", triangle);
        }
        const auto& [a, b, c] = triangle;
        const Normal inFloat =
            normalOf(rounded(mesh.vertices[a]), rounded(mesh.vertices[b]), rounded(mesh.vertices[c]));
        const Normal inDouble = normalOf(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
        if (inFloat == Normal{})
            return say("no area in float32", triangle);
        if (inFloat[0] * inDouble[0] + inFloat[1] * inDouble[1] + inFloat[2] * inDouble[2] <= 0)
            return say("one side up in double and the other in float32", triangle);
    }
    return {};
}

std::string wrongVertex(const TriangleMesh& mesh) {
    std::set<Rounded> places;
    for (const Vec3& vertex : mesh.vertices) {
        if (!places.insert(rounded(vertex)).second)
            return "two vertices at one place in float32";
    }
    std::vector<bool> used(mesh.vertices.size());
    for (const Triangle& triangle : mesh.triangles) {
        for (const auto vertex : triangle)
            used[vertex] = true;
    }
    return std::find(used.begin(), used.end(), false) == used.end() ? "" : "a vertex without a triangle";
}

std::string wrongEdge(const TriangleMesh& mesh) {
    std::set<Edge> directed;
    for (const Triangle& triangle : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (!directed.emplace(triangle[k], triangle[(k + 1) % 3]).second)
                return say("an edge used twice in one direction", triangle);
        }
    }
    for (const Edge& edge : directed) {
        if (!directed.contains({edge.second, edge.first}))
            return "an edge without its twin: " + std::to_string(edge.first) + ' ' +
                   std::to_string(edge.second);
    }
    return {};
}

/// The triangles around each vertex must form one ring: walking from neighbour to neighbour must visit all of
/// them.
std::string wrongLink(const TriangleMesh& mesh) {
    std::vector<std::map<std::uint32_t, std::uint32_t>> links(mesh.vertices.size());
    for (const Triangle& triangle : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k)
            links[triangle[k]][triangle[(k + 1) % 3]] = triangle[(k + 2) % 3];
    }
    for (std::size_t v = 0; v < links.size(); ++v) {
        const auto& link = links[v];
        std::size_t visited = 0;
        auto at = link.begin()->first;
        do {
            const auto next = link.find(at);
            if (next == link.end())
                return "an open fan round vertex " + std::to_string(v);
            at = next->second;
            ++visited;
        } while (at != link.begin()->first && visited <= link.size());
        if (visited != link.size())
            return "more than one fan round vertex " + std::to_string(v);
    }
    return {};
}

double volumeUnder(const TriangleMesh& mesh, const Triangle& triangle) {
    const Vec3& origin = mesh.vertices.front();
    return glm::dot(mesh.vertices[triangle[0]] - origin,
                    glm::cross(mesh.vertices[triangle[1]] - origin, mesh.vertices[triangle[2]] - origin)) /
           6;
}

/// The volume of each connected part.
std::map<std::uint32_t, double> partVolumes(const TriangleMesh& mesh) {
    std::vector<std::uint32_t> parent(mesh.vertices.size());
    std::iota(parent.begin(), parent.end(), 0U);
    const auto root = [&parent](std::uint32_t v) {
        while (parent[v] != v)
            v = parent[v] = parent[parent[v]];
        return v;
    };
    for (const Triangle& triangle : mesh.triangles) {
        parent[root(triangle[0])] = root(triangle[1]);
        parent[root(triangle[1])] = root(triangle[2]);
    }
    std::map<std::uint32_t, double> volumes;
    for (const Triangle& triangle : mesh.triangles)
        volumes[root(triangle[0])] += volumeUnder(mesh, triangle);
    return volumes;
}

} // namespace

std::string whatIsWrong(const TriangleMesh& mesh) {
    for (const auto check : {wrongTriangle, wrongVertex, wrongEdge, wrongLink}) {
        if (auto wrong = check(mesh); !wrong.empty())
            return wrong;
    }
    return {};
}

double signedVolume(const TriangleMesh& mesh) {
    double volume = 0;
    for (const Triangle& triangle : mesh.triangles)
        volume += volumeUnder(mesh, triangle);
    return volume;
}

double smallestPartVolume(const TriangleMesh& mesh) {
    const auto volumes = partVolumes(mesh);
    return std::min_element(volumes.begin(), volumes.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; })
        ->second;
}

std::size_t partCount(const TriangleMesh& mesh) {
    return partVolumes(mesh).size();
}

} // namespace proveout::test
