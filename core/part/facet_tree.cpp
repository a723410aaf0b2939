// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/part/facet_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "core/base/parallel.h"

namespace proveout {

namespace {

constexpr unsigned kBits = 21; ///< of each coordinate in a code
constexpr std::size_t kFacetsOfTask = 4096;
/// A tree over codes of 63 bits, then over halves of equal ones, is no deeper.
constexpr std::size_t kDeepest = 128;

/// The bits of a number, each followed by two zeros.
std::uint64_t spread(std::uint64_t value) {
    value = (value | value << 32U) & 0x001f'0000'0000'ffffULL;
    value = (value | value << 16U) & 0x001f'0000'ff00'00ffULL;
    value = (value | value << 8U) & 0x100f'00f0'0f00'f00fULL;
    value = (value | value << 4U) & 0x10c3'0c30'c30c'30c3ULL;
    return (value | value << 2U) & 0x1249'2492'4924'9249ULL;
}

std::uint64_t codeOf(const Vec3& part) {
    std::uint64_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double scaled = std::clamp(part[axis], 0.0, 1.0) * ((1U << kBits) - 1);
        code |= spread(static_cast<std::uint64_t>(scaled)) << static_cast<unsigned>(axis);
    }
    return code;
}

float below(double value) {
    const auto rounded = static_cast<float>(value);
    return static_cast<double>(rounded) <= value
               ? rounded
               : std::nextafter(rounded, -std::numeric_limits<float>::infinity());
}

/// The square of the least distance of a point from a box.
double distance2(const std::array<float, 6>& box, const Vec3& point) {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto low = static_cast<double>(box[static_cast<std::size_t>(axis)]);
        const auto high = static_cast<double>(box[static_cast<std::size_t>(axis) + 3]);
        const double away = std::max(std::max(low - point[axis], point[axis] - high), 0.0);
        sum += away * away;
    }
    return sum;
}

bool hasAbove(const std::array<float, 6>& box, const Vec3& point) {
    return double{box[0]} <= point.x && point.x <= double{box[3]} && double{box[1]} <= point.y &&
           point.y <= double{box[4]} && point.z <= double{box[5]};
}

/// Whether a facet that is not upright is above a point.
bool isAbove(const std::array<Vec3, 3>& corners, const Vec3& point) {
    std::array<double, 3> areas{}; // of the point with each side, over ground
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec2 from = Vec2(corners[k]) - Vec2(point);
        const Vec2 to = Vec2(corners[(k + 1) % 3]) - Vec2(point);
        areas[(k + 2) % 3] = from.x * to.y - from.y * to.x;
    }
    const auto [least, most] = std::ranges::minmax(areas);
    const double sum = areas[0] + areas[1] + areas[2];
    if (sum == 0 || (least < 0 && most > 0))
        return false;
    return (areas[0] * corners[0].z + areas[1] * corners[1].z + areas[2] * corners[2].z) / sum > point.z;
}

} // namespace

FacetTree::FacetTree(std::span<const Vec3> vertices, std::span<const Facet> facets) {
    if (facets.empty())
        return;
    Box all;
    for (const Vec3& vertex : vertices)
        all.add({vertex, vertex});
    m_origin = (all.lo + all.hi) / 2.0;
    const Vec3 size = glm::max(all.hi - all.lo, Vec3(1e-30));
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order(facets.size());
    inParallelRanges(facets.size(), kFacetsOfTask, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) {
            const auto& [a, b, c] = facets[k];
            const Vec3 middle = (vertices[a] + vertices[b] + vertices[c]) / 3.0;
            order[k] = {codeOf((middle - all.lo) / size), static_cast<std::uint32_t>(k)};
        }
    });
    std::ranges::sort(order);
    m_facets.resize(facets.size());
    std::vector<std::uint64_t> codes(facets.size());
    inParallelRanges(facets.size(), kFacetsOfTask, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) {
            codes[k] = order[k].first;
            const auto& [a, b, c] = facets[order[k].second];
            m_facets[k] = {{vertices[a] - m_origin, vertices[b] - m_origin, vertices[c] - m_origin},
                           order[k].second};
        }
    });
    m_nodes.reserve(facets.size() / 2 + 1);
    const Child root = build(codes, 0, facets.size());
    if (root.count > 0) // so few that there is no node: one with the same leaf twice
        m_nodes.push_back(
            {{rounded(root.box), rounded(root.box)}, {root.index, root.index}, {root.count, root.count}});
}

FacetTree::Child FacetTree::leaf(std::size_t first, std::size_t last) const {
    Box box;
    for (std::size_t k = first; k < last; ++k)
        for (const Vec3& corner : m_facets[k].corners)
            box.add({corner, corner});
    return {static_cast<std::uint32_t>(first), static_cast<std::uint8_t>(last - first), box};
}

FacetTree::Child FacetTree::build(std::span<const std::uint64_t> codes, std::size_t first, std::size_t last) {
    if (last - first <= kFacetsOfLeaf)
        return leaf(first, last);
    // At the highest bit in which the codes differ, or in the middle of equal ones.
    std::size_t split = (first + last) / 2;
    if (const std::uint64_t different = codes[first] ^ codes[last - 1]; different != 0) {
        const std::uint64_t bit = std::bit_floor(different);
        const auto isLow = [bit](std::uint64_t code) { return (code & bit) == 0; };
        const auto at = std::partition_point(codes.begin() + static_cast<std::ptrdiff_t>(first),
                                             codes.begin() + static_cast<std::ptrdiff_t>(last), isLow);
        split = static_cast<std::size_t>(at - codes.begin());
    }
    const std::size_t index = m_nodes.size();
    m_nodes.emplace_back();
    const std::array<Child, 2> children{build(codes, first, split), build(codes, split, last)};
    Box box;
    for (std::size_t k = 0; k < 2; ++k) {
        m_nodes[index].boxes[k] = rounded(children[k].box);
        m_nodes[index].children[k] = children[k].index;
        m_nodes[index].counts[k] = children[k].count;
        box.add(children[k].box);
    }
    return {static_cast<std::uint32_t>(index), 0, box};
}

std::array<float, 6> FacetTree::rounded(const Box& box) const {
    return {below(box.lo.x),   below(box.lo.y),   below(box.lo.z),
            -below(-box.hi.x), -below(-box.hi.y), -below(-box.hi.z)};
}

void FacetTree::look(std::size_t first, std::size_t count, const Vec3& point, std::optional<Nearest>& best,
                     double& least2) const {
    for (std::size_t k = first; k < first + count; ++k) {
        const SortedFacet& facet = m_facets[k];
        const NearestOnFacet at = nearestOnFacet(point, facet.corners);
        const Vec3 away = point - at.place;
        const double distance2 = glm::dot(away, away);
        if (distance2 < least2 || (distance2 == least2 && (!best || facet.index < best->facet))) {
            best = Nearest{facet.index, at, distance2};
            least2 = distance2;
        }
    }
}

std::optional<FacetTree::Nearest> FacetTree::nearest(const Vec3& place, double within) const {
    if (m_nodes.empty())
        return std::nullopt;
    const Vec3 point = place - m_origin;
    struct Waiting {
        std::uint32_t node;
        double distance2;
    };
    std::array<Waiting, kDeepest> waiting;
    std::size_t count = 0;
    std::optional<Nearest> best;
    double least2 = within * within;
    std::uint32_t at = 0;
    for (;;) {
        const Node& node = m_nodes[at];
        std::array<double, 2> away{distance2(node.boxes[0], point), distance2(node.boxes[1], point)};
        const std::size_t near = away[1] < away[0] ? 1 : 0;
        std::array<bool, 2> goesOn{false, false};
        for (const std::size_t k : {near, 1 - near}) {
            if (!(away[k] <= least2))
                continue;
            if (node.counts[k] > 0)
                look(node.children[k], node.counts[k], point, best, least2);
            else
                goesOn[k] = true;
        }
        const std::size_t far = 1 - near;
        if (goesOn[far] && away[far] <= least2)
            waiting[count++] = {node.children[far], away[far]};
        if (goesOn[near] && away[near] <= least2) {
            at = node.children[near];
            continue;
        }
        while (count > 0 && waiting[count - 1].distance2 > least2)
            --count;
        if (count == 0)
            break;
        at = waiting[--count].node;
    }
    if (best)
        best->at.place += m_origin;
    return best;
}

bool FacetTree::isBelow(const Vec3& place) const {
    if (m_nodes.empty())
        return false;
    const Vec3 point = place - m_origin;
    std::array<std::uint32_t, kDeepest> waiting;
    std::size_t count = 0;
    waiting[count++] = 0;
    while (count > 0) {
        const Node& node = m_nodes[waiting[--count]];
        for (std::size_t k = 0; k < 2; ++k) {
            if (!hasAbove(node.boxes[k], point))
                continue;
            if (node.counts[k] == 0)
                waiting[count++] = node.children[k];
            else if (std::any_of(m_facets.begin() + node.children[k],
                                 m_facets.begin() + node.children[k] + node.counts[k],
                                 [&](const SortedFacet& facet) { return isAbove(facet.corners, point); }))
                return true;
        }
    }
    return false;
}

} // namespace proveout
