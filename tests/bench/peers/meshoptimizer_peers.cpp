// SPDX-License-Identifier: GPL-3.0-or-later
#include <meshoptimizer.h>

#include "tests/bench/peers/peer.h"

namespace proveout::bench {

namespace {

PeerResult simplified(const PeerMap& map, std::size_t faces, double allowance, unsigned options) {
    std::vector<float> points;
    for (std::uint32_t i = 0; i < map.heights.size(); ++i) {
        const Vec3 point = pointOf(map, i);
        points.insert(points.end(),
                      {static_cast<float>(point.x), static_cast<float>(point.y), map.heights[i]});
    }
    std::vector<unsigned> indices;
    for (const LatticeTriangle& triangle : fullMesh(map))
        indices.insert(indices.end(), triangle.begin(), triangle.end());
    std::vector<unsigned> left(indices.size());
    constexpr std::size_t kStride = 3 * sizeof(float);
    const std::size_t count = points.size() / 3;
    const double begin = cpuSeconds();
    const float scale = meshopt_simplifyScale(points.data(), count, kStride);
    left.resize(meshopt_simplify(left.data(), indices.data(), indices.size(), points.data(), count, kStride,
                                 faces * 3, static_cast<float>(allowance) / scale, options, nullptr));
    PeerResult result{{}, {}, cpuSeconds() - begin};
    for (std::size_t i = 0; i + 2 < left.size(); i += 3)
        result.triangles.push_back({left[i], left[i + 1], left[i + 2]});
    return result;
}

} // namespace

Peers meshoptimizerPeers() {
    return {
        {"meshoptimizer", "ε",
         [](const PeerMap& map, double allowance, std::size_t) { return simplified(map, 0, allowance, 0); }},
        {"meshoptimizer, borders locked", "ε",
         [](const PeerMap& map, double allowance, std::size_t) {
             return simplified(map, 0, allowance, meshopt_SimplifyLockBorder);
         }},
        {"meshoptimizer", "our faces", [](const PeerMap& map, double, std::size_t faces) {
             constexpr double kAny = 1e3;
             return simplified(map, faces, kAny, 0);
         }}};
}

} // namespace proveout::bench
