// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/map_picture.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/parallel.h"

namespace proveout {

namespace {

constexpr Rgb kStock{186, 191, 198};
constexpr Rgb kNothing{255, 255, 255}; ///< the stock is cut through
constexpr Rgb kInTolerance{205, 212, 205};
constexpr Rgb kMissing{213, 94, 0};
constexpr Rgb kLeft{0, 114, 178};
/// How much of the colour is due to its band, and how much to how far beyond the tolerance it is.
constexpr double kLeastStrength = 0.55;
constexpr double kStrongest = 4; // tolerances

Rgb mixed(const Rgb& one, const Rgb& other, double share) {
    Rgb out{};
    for (std::size_t k = 0; k < out.size(); ++k)
        out[k] = static_cast<std::uint8_t>(std::lround(one[k] + (other[k] - one[k]) * share));
    return out;
}

Rgb lit(const Rgb& colour, double light) {
    Rgb out{};
    for (std::size_t k = 0; k < out.size(); ++k)
        out[k] = static_cast<std::uint8_t>(std::lround(std::clamp(colour[k] * light, 0.0, 255.0)));
    return out;
}

/// How the points of a grid become pixels: `step` × `step` of them each.
class Raster {
public:
    explicit Raster(const Grid& grid)
        : m_grid(grid), m_step((std::max(grid.nx, grid.ny) + kPictureSide - 1) / kPictureSide) {}

    [[nodiscard]] Picture empty() const {
        Picture picture{(m_grid.nx + m_step - 1) / m_step, (m_grid.ny + m_step - 1) / m_step, {}};
        picture.pixels.resize(static_cast<std::size_t>(picture.width) *
                              static_cast<std::size_t>(picture.height));
        return picture;
    }
    /// The points of a pixel; y counts from the top.
    [[nodiscard]] IndexRect pointsOf(const Picture& picture, int x, int y) const {
        const int row = picture.height - 1 - y;
        return {x * m_step, row * m_step, std::min((x + 1) * m_step, m_grid.nx),
                std::min((row + 1) * m_step, m_grid.ny)};
    }
    [[nodiscard]] std::size_t pixelOf(const Picture& picture, int i, int j) const {
        const int y = picture.height - 1 - j / m_step;
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
               static_cast<std::size_t>(i / m_step);
    }

private:
    Grid m_grid;
    int m_step;
};

/// The light on a point, from the slope of the map around it.
double lightOn(const ZMapSnapshot& stock, int i, int j) {
    const Grid& grid = stock.grid();
    const int west = std::max(i - 1, 0);
    const int east = std::min(i + 1, grid.nx - 1);
    const int south = std::max(j - 1, 0);
    const int north = std::min(j + 1, grid.ny - 1);
    const auto height = [&](int x, int y) { return static_cast<double>(stock.height(x, y)); };
    const Vec3 normal =
        glm::normalize(Vec3((height(west, j) - height(east, j)) / (grid.hx * (east - west)),
                            (height(i, south) - height(i, north)) / (grid.hy * (north - south)), 1));
    const Vec3 light = glm::normalize(Vec3(-0.5, 0.6, 1));
    return 0.35 + 0.8 * std::max(glm::dot(normal, light), 0.0);
}

template<class ColourOf>
Picture drawn(const ZMapSnapshot& stock, Shading shading, const ColourOf& colourOf) {
    const Raster raster(stock.grid());
    Picture picture = raster.empty();
    inParallel(static_cast<std::size_t>(picture.height), [&](std::size_t y) {
        for (int x = 0; x < picture.width; ++x) {
            const IndexRect points = raster.pointsOf(picture, x, static_cast<int>(y));
            const int i = (points.i0 + points.i1 - 1) / 2;
            const int j = (points.j0 + points.j1 - 1) / 2;
            const bool isLeft = stock.height(i, j) > stock.floor();
            const Rgb colour = colourOf(points, raster.pixelOf(picture, i, j), isLeft);
            picture.at(x, static_cast<int>(y)) =
                isLeft && shading == Shading::lit ? lit(colour, lightOn(stock, i, j)) : colour;
        }
    });
    return picture;
}

/// The one that is farther out of tolerance, in tolerances.
double badness(double off, const PartTolerance& tolerance) {
    const double allowed = off < 0 ? tolerance.below : tolerance.above;
    return std::abs(off) / std::max(allowed, 1e-6);
}

} // namespace

Rgb deviationColour(double off, const PartTolerance& tolerance) {
    const double bad = badness(off, tolerance);
    const Rgb& towards = off < 0 ? kMissing : kLeft;
    if (bad <= 1)
        return mixed(kInTolerance, towards, 0.2 * bad);
    const double beyond = std::min((bad - 1) / (kStrongest - 1), 1.0);
    return mixed(kInTolerance, towards, kLeastStrength + (1 - kLeastStrength) * beyond);
}

Picture stockPicture(const ZMapSnapshot& stock) {
    return drawn(stock, Shading::lit,
                 [](const IndexRect&, std::size_t, bool isLeft) { return isLeft ? kStock : kNothing; });
}

Picture deviationPicture(const Deviation& deviation, const PartTolerance& tolerance, Shading shading) {
    const Raster raster(deviation.grid());
    const Picture shape = raster.empty();
    std::vector<float> ofWalls(shape.pixels.size(), kNotJudged);
    const auto isWorse = [&](double off, double than) {
        return std::isnan(than) || badness(off, tolerance) > badness(than, tolerance);
    };
    for (const WallDeviation& wall : deviation.walls()) {
        const double off = static_cast<double>(wall.value) - tolerance.allowance;
        float& worst = ofWalls[raster.pixelOf(shape, wall.i, wall.j)];
        if (isWorse(off, static_cast<double>(worst)))
            worst = static_cast<float>(off);
    }
    return drawn(deviation.stock(), shading, [&](const IndexRect& points, std::size_t pixel, bool isLeft) {
        auto worst = static_cast<double>(ofWalls[pixel]);
        for (int j = points.j0; j < points.j1; ++j)
            for (int i = points.i0; i < points.i1; ++i) {
                const double off = static_cast<double>(deviation.at(i, j)) - tolerance.allowance;
                if (!std::isnan(off) && isWorse(off, worst))
                    worst = off;
            }
        if (std::isnan(worst))
            return isLeft ? kStock : kNothing;
        return deviationColour(worst, tolerance);
    });
}

} // namespace proveout
