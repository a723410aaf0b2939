// SPDX-License-Identifier: GPL-3.0-or-later
// Stock meshes that are not in the corpus.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <limits>
#include <optional>

#include "tests/bench/faults/written_faults.h"

namespace proveout {

namespace {

using Corner = std::array<float, 3>;
using Facet = std::array<Corner, 3>;
using Facets = std::vector<Facet>;

/// Twelve facets that face outwards.
Facets cube(float size, Corner at = {}) {
    static constexpr int kSides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                         {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    const auto corner = [&](int index) {
        const auto along = [&](int axis) {
            return at[static_cast<std::size_t>(axis)] + ((index >> axis) & 1 ? size : 0);
        };
        return Corner{along(0), along(1), along(2)};
    };
    Facets facets;
    for (const auto& side : kSides) {
        facets.push_back({corner(side[0]), corner(side[1]), corner(side[2])});
        facets.push_back({corner(side[0]), corner(side[2]), corner(side[3])});
    }
    return facets;
}

template<typename Value>
void append(std::string& bytes, Value value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// A binary STL without normals.
std::string binaryStl(const Facets& facets, std::optional<std::uint32_t> announced = {}) {
    std::string bytes(80, ' ');
    append(bytes, announced.value_or(static_cast<std::uint32_t>(facets.size())));
    for (const Facet& facet : facets) {
        append(bytes, Corner{});
        append(bytes, facet);
        append(bytes, std::uint16_t{0});
    }
    return bytes;
}

std::string asciiStl(const Facets& facets) {
    std::string text = "solid cube\n";
    for (const Facet& facet : facets) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const Corner& corner : facet)
            text += fmt::format("vertex {} {} {}\n", corner[0], corner[1], corner[2]);
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid cube\n";
}

Facets with(Facets facets, const Facets& more) {
    facets.insert(facets.end(), more.begin(), more.end());
    return facets;
}

Facets insideOut(Facets facets) {
    for (Facet& facet : facets)
        std::swap(facet[0], facet[1]);
    return facets;
}

/// A plate of 1000 mm with waves on top: 4 n² facets and those of its sides.
Facets waves(int n) {
    const auto at = [n](int i, int j, bool top) {
        const auto x = static_cast<float>(1000.0 * i / n);
        const auto y = static_cast<float>(1000.0 * j / n);
        return Corner{x, y, top ? 20 + 5 * std::sin(x / 30) * std::cos(y / 50) : 0.0F};
    };
    Facets facets;
    const auto quad = [&facets](const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
        facets.push_back({a, b, c});
        facets.push_back({a, c, d});
    };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            quad(at(i, j, true), at(i + 1, j, true), at(i + 1, j + 1, true), at(i, j + 1, true));
            quad(at(i, j, false), at(i, j + 1, false), at(i + 1, j + 1, false), at(i + 1, j, false));
        }
    for (int k = 0; k < n; ++k) {
        quad(at(k, 0, false), at(k + 1, 0, false), at(k + 1, 0, true), at(k, 0, true));
        quad(at(n, k, false), at(n, k + 1, false), at(n, k + 1, true), at(n, k, true));
        quad(at(k + 1, n, false), at(k, n, false), at(k, n, true), at(k + 1, n, true));
        quad(at(0, k + 1, false), at(0, k, false), at(0, k, true), at(0, k + 1, true));
    }
    return facets;
}

FaultCase& putMesh(FaultWriter& writer, int number, const std::string& name, const std::string& bytes,
                   double grid = 0.5) {
    writer.write(name + ".stl", bytes);
    return writer.putStock(number, name, "stl", name + ".stl", grid);
}

void writeManyFacets(FaultWriter& writer) {
    putMesh(writer, 48, "facets-1.2M", binaryStl(waves(547)), 5).seconds = 3; // the test is about loading
    constexpr std::uint32_t kFacets = 100'000'000;
    putMesh(writer, 48, "facets-100M", binaryStl({}, kFacets));
    writer.lengthen("facets-100M.stl", 84 + std::uintmax_t{50} * kFacets);
}

} // namespace

void writeMeshFaults(FaultWriter& writer) {
    const Facets good = cube(10);
    const auto put = [&writer](int number, const std::string& name, const std::string& bytes) {
        putMesh(writer, number, name, bytes);
    };
    put(39, "count-ffffffff", binaryStl(good, std::numeric_limits<std::uint32_t>::max()));
    put(40, "count-too-big", binaryStl(good, 24));
    put(40, "truncated-facet", binaryStl(good).substr(0, 84 + 50 * 11 + 25));
    put(40, "ascii-cut", asciiStl(good).substr(0, 700));
    put(42, "bin-1e38", binaryStl(cube(3e38F)));
    put(42, "bin-1e38-around", binaryStl(cube(3.4e38F, {-1.7e38F, -1.7e38F, -1.7e38F})));
    put(43, "duplicate-facets", binaryStl(with(good, {good[3]})));
    put(43, "zero-normals", binaryStl(good));
    put(44, "inside-out", binaryStl(insideOut(good)));
    put(45, "fin", binaryStl(with(good, {{Corner{0, 0, 10}, Corner{10, 0, 10}, Corner{5, -5, 15}}})));
    put(45, "overlap", binaryStl(with(good, cube(10, {5, 5, 0}))));
    put(46, "metres", binaryStl(cube(0.1F)));
    put(46, "kilometre", binaryStl(cube(1e6F)));
    put(47, "html-named-stl", "<!DOCTYPE html>\n<html><body>404 Not Found</body></html>\n");
    writeManyFacets(writer);
}

} // namespace proveout
