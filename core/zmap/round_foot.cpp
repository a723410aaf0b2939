// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/zmap/round_foot.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace proveout {

namespace {

/// Gauss-Legendre from 0 to 1.
constexpr std::array<double, 4> kPlaces{0.069431844202973712, 0.33000947820757187, 0.66999052179242813,
                                        0.93056815579702629};
constexpr std::array<double, 4> kWeights{0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                         0.17392742256872693};

double squareOf(double value) {
    return value * value;
}

/// How far the wall goes on above `atWall`: the conic passes through all three samples.
double riseAbove(const FootSample& atWall, const FootSample& first, const FootSample& second) {
    const double x0 = atWall.distance;
    const double x1 = first.distance;
    const double x2 = second.distance;
    const std::array<double, 3> weights{x1 * x2 * (x2 - x1), x0 * x2 * (x0 - x2), x0 * x1 * (x1 - x0)};
    const double down1 = first.height - atWall.height;
    const double down2 = second.height - atWall.height;
    const double a = weights[0] + weights[1] + weights[2];
    const double b = weights[1] * down1 + weights[2] * down2;
    const double c = weights[1] * squareOf(down1) + weights[2] * squareOf(down2);
    const double root = b * b - a * c;
    if (!(root >= 0) || a == 0)
        return 0;
    const double one = (b + std::sqrt(root)) / a;
    const double other = (b - std::sqrt(root)) / a;
    const double least = std::min(one, other);
    return least >= 0 ? least : std::max(one, 0.0);
}

} // namespace

std::optional<RoundFoot> RoundFoot::through(const FootSample& atWall, double highest, const FootSample& first,
                                            const FootSample& second) {
    if (!(first.height < atWall.height))
        return std::nullopt;
    const FootSample low{second.distance, std::min(first.height, second.height)};
    const double bottom =
        first.distance > 2 * atWall.distance ? atWall.height + riseAbove(atWall, first, low) : atWall.height;
    return through(first, second, std::clamp(bottom, atWall.height, std::max(highest, atWall.height)));
}

std::optional<RoundFoot> RoundFoot::through(const FootSample& first, const FootSample& second,
                                            double bottom) {
    if (!(first.height < bottom) || second.height > (first.height + bottom) / 2)
        return std::nullopt;
    const double slope1 = squareOf(bottom - first.height) / first.distance;
    const double slope2 = squareOf(bottom - std::min(first.height, second.height)) / second.distance;
    RoundFoot foot{bottom, 0, (slope2 - slope1) / (second.distance - first.distance)};
    foot.linear = slope1 - foot.square * first.distance;
    return foot.linear < 0 ? RoundFoot{bottom, 0, slope2 / second.distance} : foot;
}

double RoundFoot::fall(double distance) const {
    const double farthest = square < 0 ? -linear / (2 * square) : distance;
    const double x = std::clamp(distance, 0.0, farthest);
    return std::sqrt(std::max(0.0, (linear + square * x) * x));
}

double RoundFoot::slopeAt(double distance) const {
    const double below = fall(distance);
    return below > 0 ? std::max(0.0, linear / 2 + square * distance) / below : 0;
}

double RoundFoot::sagBeyond(double distance, double step) const {
    const double slope = slopeAt(distance);
    const double lastSlope = std::sqrt(std::max(square, 0.0));
    // By the formula of Euler and Maclaurin.
    return distance > 0 ? std::max(0.0, slope - lastSlope) * step * step / (6 * distance) : 0;
}

double RoundFoot::meanFall(std::array<double, 3> distances) const {
    std::ranges::sort(distances);
    const double low = distances[0];
    const double middle = distances[1];
    const double high = distances[2];
    if (!(high > low))
        return fall(low);
    double mean = 0;
    // How much of the triangle is at a distance grows up to the middle one, and falls to the largest.
    const auto add = [&](double from, double to, double least, double most) {
        for (std::size_t k = 0; k < kPlaces.size(); ++k) {
            const double u = kPlaces[k];
            const double part = least + (most - least) * u * u;
            mean +=
                kWeights[k] * 4 * u * (to - from) / (high - low) * part * fall(from + (to - from) * u * u);
        }
    };
    add(low, middle, 0, 1);
    add(middle, high, 1, 0);
    return mean;
}

} // namespace proveout
