// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/lee/lee_decimator.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/decimation/lee/vertex_error.h"
#include "core/decimation/regions/random_order.h"

namespace proveout {

using OpenMesh::VertexHandle;

RegionMesh LeeDecimator::decimate(const RegionGrid& grid, const RegionSamples& samples,
                                  const std::array<BorderLinePtr, 4>& borders, std::uint64_t seed,
                                  const DecimationParameters& parameters, const std::stop_token& stop) {
    build(samples, borders, parameters); // step 1
    if (parameters.allowance > 0) {
        orderVertices(borders, seed, parameters);
        for (const std::uint32_t vertex : m_order) { // steps 2 and 3
            if (stop.stop_requested())
                return {};
            tryRemove(VertexHandle(static_cast<int>(vertex)));
        }
    }
    return result(grid, samples); // step 4
}

void LeeDecimator::build(const RegionSamples& samples, const std::array<BorderLinePtr, 4>& borders,
                         const DecimationParameters& parameters) {
    m_mesh.build(samples.rect, samples.heights);
    for (const Side side : kSides)
        if (const BorderLinePtr& line = borders[static_cast<std::size_t>(side)])
            m_mesh.drawBorder(side, *line);
    m_error.assign(samples.heights.size(), 0.0);
    m_heights = {samples.heights, static_cast<std::size_t>(samples.rect.width())};
    m_hx = samples.hx;
    m_hy = samples.hy;
    m_allowance = parameters.allowance;
    m_certify = parameters.certify;
    m_limit = m_allowance - roundingGuard(samples.heights);
}

void LeeDecimator::orderVertices(const std::array<BorderLinePtr, 4>& borders, std::uint64_t seed,
                                 const DecimationParameters& parameters) {
    const auto isGiven = [&](Side side) { return borders[static_cast<std::size_t>(side)] != nullptr; };
    const int east = m_mesh.width() - 1;
    const int north = m_mesh.height() - 1;
    m_order.clear();
    for (int j = 0; j <= north; ++j) {
        for (int i = 0; i <= east; ++i) {
            const bool isFixed = (j == 0 && isGiven(Side::south)) || (j == north && isGiven(Side::north)) ||
                                 (i == 0 && isGiven(Side::west)) || (i == east && isGiven(Side::east));
            const VertexHandle vertex = m_mesh.vertex(i, j);
            if (!isFixed && !m_mesh.isCorner(vertex))
                m_order.push_back(static_cast<std::uint32_t>(vertex.idx()));
        }
    }
    arrange(m_order, parameters.order, seed);
}

/// Paper §4.2. The accumulated error is interpreted as follows: a removed vertex passes its *total* error
/// (its local error and what it had accumulated) to the one vertex that it collapses into, not to its other
/// neighbours. The text, "the vertex error e_j is distributed to V_i using e_i = e_i + e_j", admits only that
/// one V_i, and calls the total "the total error e_i".
void LeeDecimator::tryRemove(VertexHandle vertex) {
    const Star& star = m_mesh.star(vertex);
    const double total = localError(star) + m_error[static_cast<std::size_t>(vertex.idx())];
    if (total > m_allowance)
        return;

    const std::size_t count = star.spokes.size();
    m_lengths.resize(count);
    constexpr double kRefused = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < count; ++k) {
        const OpenMesh::Vec3d& offset = star.spokes[k].offset;
        const double x = offset[0] * m_hx;
        const double y = offset[1] * m_hy;
        // A border vertex moves only along the border (§4.3.2).
        const bool isCandidate = star.closed || k == 0 || k + 1 == count;
        m_lengths[k] = isCandidate ? x * x + y * y + offset[2] * offset[2] : kRefused;
    }
    for (;;) {
        // The shortest edge first (§4.2.2); of equal ones that to the vertex that comes first in the region,
        // because the order of the spokes depends on OpenMesh.
        std::size_t target = 0;
        for (std::size_t k = 1; k < count; ++k) {
            const bool isShorter = m_lengths[k] < m_lengths[target] ||
                                   (m_lengths[k] == m_lengths[target] &&
                                    star.spokes[k].tip.idx() < star.spokes[target].tip.idx());
            target = isShorter ? k : target;
        }
        if (m_lengths[target] == kRefused)
            return;
        if (m_mesh.isCollapseValid(star, target) && (!m_certify || staysWithin(star, target))) {
            m_error[static_cast<std::size_t>(star.spokes[target].tip.idx())] += total;
            m_mesh.collapse(star, target);
            return;
        }
        m_lengths[target] = kRefused;
    }
}

double LeeDecimator::localError(const Star& star) const {
    return star.closed ? averagePlaneDistance(star, m_hx, m_hy) : borderLineDistance(star, m_hx, m_hy);
}

/// Whether all points covered by the faces that a collapse would change stay within the allowance. The faces
/// cover the same points before and after, borders included, and all other faces stay unchanged: therefore a
/// property of the full mesh holds after every step.
bool LeeDecimator::staysWithin(const Star& star, std::size_t target) const {
    const LatticeCorner to = corner(star.spokes[target].tip);
    for (std::size_t k = 0; k < star.faceCount(); ++k) {
        const std::size_t next = star.nextSpoke(k);
        if (k == target || next == target)
            continue;
        const bool within =
            scanTriangle(to, corner(star.spokes[k].tip), corner(star.spokes[next].tip),
                         [&](const LatticeRun& run) { return runWithin(m_heights, run, m_limit); });
        if (!within)
            return false;
    }
    return true;
}

LatticeCorner LeeDecimator::corner(VertexHandle vertex) const {
    const OpenMesh::Vec3d& point = m_mesh.mesh().point(vertex);
    return {point[0], point[1], point[2]};
}

RegionMesh LeeDecimator::result(const RegionGrid& grid, const RegionSamples& samples) const {
    RegionMesh mesh;
    mesh.triangles.reserve(m_mesh.faceCount());
    const auto lattice = [&](const LatticeCorner& point) {
        return grid.lattice(samples.rect.i0 + static_cast<int>(point.i),
                            samples.rect.j0 + static_cast<int>(point.j));
    };
    m_mesh.forEachFace([&](VertexHandle va, VertexHandle vb, VertexHandle vc) {
        const LatticeCorner a = corner(va);
        const LatticeCorner b = corner(vb);
        const LatticeCorner c = corner(vc);
        mesh.triangles.push_back({lattice(a), lattice(b), lattice(c)});
        scanTriangle(a, b, c, [&](const LatticeRun& run) {
            mesh.largestError = std::max(mesh.largestError, runDistance(m_heights, run));
            return true;
        });
    });
    return mesh;
}

} // namespace proveout
