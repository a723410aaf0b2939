// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/region_faces.h"

#include <algorithm>
#include <utility>

namespace proveout {

namespace {

/// The number of cells between the points of a rectangle.
double cells(const IndexRect& points) {
    return double(std::max(0, points.width() - 1)) * double(std::max(0, points.height() - 1));
}

} // namespace

RegionFaces::RegionFaces(const RegionGrid& grid, std::vector<double> uncut)
    : m_grid(grid), m_uncut(std::move(uncut)), m_now(m_uncut) {}

double RegionFaces::beyondUncut(const IndexRect& points) const {
    const IndexRect near = m_grid.regionsTouching(points);
    double sum = 0;
    for (int ry = near.j0; ry < near.j1; ++ry)
        for (int rx = near.i0; rx < near.i1; ++rx) {
            const std::size_t region = m_grid.regionAt(rx, ry);
            const IndexRect own = m_grid.points(region);
            sum += (m_now[region] - m_uncut[region]) * cells(intersection(own, points)) / cells(own);
        }
    return sum;
}

std::vector<double> RegionFaces::update(std::span<const std::size_t> touched,
                                        std::span<const std::size_t> drawn, const SurfaceSnapshot& surface,
                                        const RegionFaces& reference) {
    for (const std::size_t region : touched)
        if (const RegionMeshPtr& mesh = surface.meshes[region])
            m_now[region] = static_cast<double>(mesh->triangles.size());
    m_beyond /= 2;
    m_referenceBeyond /= 2;
    for (const std::size_t region : drawn) {
        m_beyond += m_now[region] - m_uncut[region];
        m_referenceBeyond += reference.beyondUncut(m_grid.points(region));
    }
    const double factor = m_referenceBeyond > 0 ? std::max(0.0, m_beyond / m_referenceBeyond) : 1;
    std::vector<double> faces;
    faces.reserve(touched.size());
    for (const std::size_t region : touched) {
        const IndexRect points = m_grid.points(region);
        if (!surface.meshes[region])
            m_now[region] = std::clamp(m_uncut[region] + factor * reference.beyondUncut(points), 2.0,
                                       static_cast<double>(fullRegionFaces(m_grid, region)));
        faces.push_back(m_now[region]);
    }
    return faces;
}

} // namespace proveout
