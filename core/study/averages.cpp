// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/averages.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace proveout {

namespace {

Vec2 mean(std::span<const Vec2> points) {
    Vec2 sum{0};
    for (const Vec2& point : points)
        sum += point;
    return sum / static_cast<double>(points.size());
}

} // namespace

std::vector<Vec2> windowAverages(std::span<const Vec2> points, std::size_t window) {
    std::vector<Vec2> averages;
    for (std::size_t begin = 0; begin < points.size(); begin += window)
        averages.push_back(mean(points.subspan(begin, std::min(window, points.size() - begin))));
    return averages;
}

std::vector<Vec2> straightLine(std::span<const Vec2> points) {
    if (points.size() < 2)
        return {};
    const Vec2 centre = mean(points);
    double xx = 0;
    double xy = 0;
    for (const Vec2& point : points) {
        xx += (point.x - centre.x) * (point.x - centre.x);
        xy += (point.x - centre.x) * (point.y - centre.y);
    }
    if (xx == 0)
        return {};
    const auto at = [&](double x) { return Vec2(x, centre.y + xy / xx * (x - centre.x)); };
    const auto byX = [](const Vec2& a, const Vec2& b) { return a.x < b.x; };
    const auto [first, last] = std::minmax_element(points.begin(), points.end(), byX);
    return {at(first->x), at(last->x)};
}

double quantile(std::vector<double> values, double q) {
    if (values.empty())
        return std::numeric_limits<double>::quiet_NaN();
    std::sort(values.begin(), values.end());
    const double place = q * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(std::floor(place));
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (place - std::floor(place)) * (values[above] - values[below]);
}

Measured measured(const std::vector<double>& values) {
    const double median = quantile(values, 0.5);
    return {median, median > 0 ? (quantile(values, 0.75) - quantile(values, 0.25)) / median : 0};
}

} // namespace proveout
