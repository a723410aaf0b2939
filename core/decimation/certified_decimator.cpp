// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/certified_decimator.h"

#include <algorithm>
#include <cmath>

#include "core/decimation/certified_border.h"

namespace proveout {

namespace {

BorderLine ownBorder(const RegionSamples& samples, Side side, double allowance) {
    const auto width = static_cast<std::size_t>(samples.rect.width());
    const auto height = static_cast<std::size_t>(samples.rect.height());
    const bool alongX = side == Side::south || side == Side::north;
    const std::size_t first = side == Side::north ? (height - 1) * width : side == Side::east ? width - 1 : 0;
    std::vector<float> heights(alongX ? width : height);
    for (std::size_t k = 0; k < heights.size(); ++k)
        heights[k] = samples.heights[first + k * (alongX ? 1 : width)];
    return certifiedBorder(heights, allowance);
}

/// The full mesh, which is exact; at the surface level it needs all points of its borders.
RegionMesh fullMesh(const RegionGrid& grid, const RegionSamples& samples,
                    const std::array<BorderLinePtr, 4>& borders, const DecimationParameters& parameters) {
    RegionMesh mesh;
    const std::size_t region = grid.regionAt(samples.rect.i0 / grid.cells(), samples.rect.j0 / grid.cells());
    mesh.triangles = fullRegionMesh(grid, region, borders);
    mesh.largestError = parameters.allowance; // what the polylines of the borders may take
    if (parameters.level != ErrorLevel::surface)
        return mesh;
    for (const Side side : kSides) {
        const BorderLinePtr& line = borders[static_cast<std::size_t>(side)];
        for (std::uint32_t k = 0; line && k < line->kept.back(); ++k)
            if (!std::binary_search(line->kept.begin(), line->kept.end(), k))
                mesh.wanted.push_back({side, k});
    }
    return mesh;
}

} // namespace

RegionMesh CertifiedDecimator::decimate(const RegionGrid& grid, const RegionSamples& samples,
                                        const std::array<BorderLinePtr, 4>& borders, std::uint64_t,
                                        const DecimationParameters& parameters, const std::stop_token& stop) {
    m_patch.load(samples);
    if (parameters.allowance <= 0)
        return fullMesh(grid, samples, {}, parameters);
    if (!(m_patch.guard(parameters.allowance) <= parameters.allowance / 2))
        return fullMesh(grid, samples, borders, parameters);

    // The largest float that is not above the allowance.
    auto limit = static_cast<float>(parameters.allowance);
    if (double{limit} > parameters.allowance)
        limit = std::nextafter(limit, 0.0F);
    std::array<BorderLine, 4> own;
    std::array<std::span<const std::uint32_t>, 4> kept;
    for (const Side side : kSides) {
        const auto k = static_cast<std::size_t>(side);
        if (!borders[k])
            own[k] = ownBorder(samples, side, borderAllowance(parameters));
        kept[k] = borders[k] ? borders[k]->kept : own[k].kept;
    }
    const bool surface = parameters.level == ErrorLevel::surface;
    const bool finished = m_insertion.run(m_patch, kept, limit, surface, m_mesh, stop) &&
                          m_removal.run(m_patch, limit, surface, m_insertion.extras(), m_mesh, stop);
    if (!finished)
        return {};
    RegionMesh mesh = result(grid, samples, parameters.allowance);
    for (const std::int32_t v : m_insertion.extras())
        if (!m_removal.isRemoved(v) && borders[static_cast<std::size_t>(borderPoint(v).side)])
            mesh.wanted.push_back(borderPoint(v));
    return mesh;
}

RegionMesh CertifiedDecimator::result(const RegionGrid& grid, const RegionSamples& samples,
                                      double allowance) const {
    RegionMesh mesh;
    float largest = 0;
    std::size_t count = 0;
    for (std::size_t t = 0; t < m_mesh.triangleSlots(); ++t)
        count += m_mesh.isAlive(static_cast<std::int32_t>(t)) ? 1 : 0;
    mesh.triangles.reserve(count);
    const auto lattice = [&](std::int32_t v) {
        const PatchVertex& p = m_mesh.vertex(v);
        return grid.lattice(samples.rect.i0 + p.i, samples.rect.j0 + p.j);
    };
    for (std::size_t t = 0; t < m_mesh.triangleSlots(); ++t) {
        if (!m_mesh.isAlive(static_cast<std::int32_t>(t)))
            continue;
        const LatticeTriangulation::Triangle& triangle = m_mesh.triangle(static_cast<std::int32_t>(t));
        mesh.triangles.push_back(
            {lattice(triangle.vertex[0]), lattice(triangle.vertex[1]), lattice(triangle.vertex[2])});
        largest = std::max(largest, triangle.distance);
    }
    for (const Side side : kSides)
        largest = std::max(largest, outlineDistance(side));
    // Borders are certified in doubles: what floats add to them here may go beyond the allowance.
    mesh.largestError = std::min(double{largest}, allowance);
    return mesh;
}

float CertifiedDecimator::outlineDistance(Side side) const {
    constexpr std::array kFirstCorner{0, 3, 0,
                                      1}; // in the order of kSides; the outline runs counter-clockwise
    constexpr std::array kLastCorner{1, 2, 3, 2};
    const bool runsBackwards = side == Side::north || side == Side::west;
    const auto k = static_cast<std::size_t>(side);
    const std::int32_t last = runsBackwards ? kFirstCorner[k] : kLastCorner[k];
    std::int32_t v = runsBackwards ? kLastCorner[k] : kFirstCorner[k];
    float largest = 0;
    while (v != last) {
        const std::int32_t edge = m_mesh.outlineFrom(v);
        const std::int32_t next = m_mesh.origin(LatticeTriangulation::next(edge));
        largest =
            std::max(largest, farthestBorderPoint(m_patch, m_mesh.vertex(v), m_mesh.vertex(next)).distance);
        v = next;
    }
    return largest;
}

BorderPoint CertifiedDecimator::borderPoint(std::int32_t v) const {
    const PatchVertex& p = m_mesh.vertex(v);
    if (p.j == 0 || p.j == m_patch.height() - 1)
        return {p.j == 0 ? Side::south : Side::north, static_cast<std::uint32_t>(p.i)};
    return {p.i == 0 ? Side::west : Side::east, static_cast<std::uint32_t>(p.j)};
}

} // namespace proveout
