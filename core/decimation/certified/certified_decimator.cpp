// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/certified/certified_decimator.h"

#include <algorithm>

#include "core/decimation/certified/certified_border.h"
#include "core/decimation/lattice/patch_mesh.h"

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
    std::vector<std::uint32_t> walls;
    for (std::size_t k = 0; k < heights.size(); ++k) {
        if (std::ranges::binary_search(samples.walls, first + k * (alongX ? 1 : width)))
            walls.push_back(static_cast<std::uint32_t>(k));
    }
    return certifiedBorder(heights, allowance, walls);
}

/// The full mesh, which is exact; at the surface level it needs all points of its borders.
RegionMesh fullMesh(const RegionGrid& grid, const RegionSamples& samples,
                    const std::array<BorderLinePtr, 4>& borders, const DecimationParameters& parameters) {
    RegionMesh mesh;
    const std::size_t region = grid.regionAt(samples.rect.i0 / grid.cells(), samples.rect.j0 / grid.cells());
    mesh.triangles = fullRegionMesh(grid, region, borders);
    mesh.largestError = parameters.allowance; // what the polylines of the borders may deviate by
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

    const float limit = floatNotAbove(parameters.allowance);
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
    RegionMesh mesh = regionMeshOf(m_mesh, m_patch, grid, samples.rect, parameters);
    for (const std::int32_t v : m_insertion.extras())
        if (!m_removal.isRemoved(v) && borders[static_cast<std::size_t>(borderPoint(v).side)])
            mesh.wanted.push_back(borderPoint(v));
    return mesh;
}

BorderPoint CertifiedDecimator::borderPoint(std::int32_t v) const {
    const PatchVertex& p = m_mesh.vertex(v);
    if (p.j == 0 || p.j == m_patch.height() - 1)
        return {p.j == 0 ? Side::south : Side::north, static_cast<std::uint32_t>(p.i)};
    return {p.i == 0 ? Side::west : Side::east, static_cast<std::uint32_t>(p.j)};
}

} // namespace proveout
