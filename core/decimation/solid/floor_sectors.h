// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/geometry.h"

namespace proveout {

/// A corner of a triangle at a given vertex: the triangle is (vertex, next, previous), counter-clockwise seen
/// from +Z.
struct Corner {
    std::size_t triangle = 0;
    int place = 0; ///< which of its three vertices
    std::uint32_t next = 0;
    std::uint32_t previous = 0;
    Vec2 toNext{0}; ///< in plan, mm
    Vec2 toPrevious{0};
};

/// Adjacent corners in counter-clockwise order: a fan of triangles around their vertex.
struct Sector {
    std::vector<Corner> corners;
    Vec2 offset{0}; ///< position of the sector's own copy of the vertex, relative to the vertex
};

/// Divides the corners at one vertex into sectors: the material around a vertex that touches itself there. If
/// there are two or more, their offsets separate the copies by `gap`, each into its own sector. Offsets are
/// shortened where triangles are so thin that a longer one would turn them over.
[[nodiscard]] std::vector<Sector> sectorsAround(std::span<const Corner> corners, double gap);

} // namespace proveout
