// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/decimation/maps.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace proveout::test {

namespace {

double uniform(std::mt19937& random) {
    return static_cast<double>(random()) / 4294967296.0;
}

template<class HeightAt>
Heights fill(int nx, int ny, double spacing, HeightAt&& heightAt) {
    Heights heights;
    heights.reserve(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny));
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i)
            heights.push_back(static_cast<float>(std::clamp(heightAt(i * spacing, j * spacing), -99.0, 0.0)));
    return heights;
}

Heights flat(int nx, int ny, double spacing, std::uint32_t seed) {
    return fill(nx, ny, spacing, [&](double, double) { return -(seed % 7) * 1.1; });
}

Heights terrain(int nx, int ny, double spacing, std::uint32_t seed) {
    std::mt19937 random(seed);
    struct Wave {
        double kx, ky, phase, height;
    };
    std::vector<Wave> waves;
    for (int k = 0; k < 8; ++k) {
        const double length = 4 + 30 * uniform(random);
        const double angle = 6.28318 * uniform(random);
        waves.push_back({std::cos(angle) * 6.28318 / length, std::sin(angle) * 6.28318 / length,
                         6.28318 * uniform(random), 0.06 * length * uniform(random)});
    }
    return fill(nx, ny, spacing, [&](double x, double y) {
        double z = -20;
        for (const Wave& wave : waves)
            z += wave.height * std::sin(wave.kx * x + wave.ky * y + wave.phase);
        return z;
    });
}

Heights walls(int nx, int ny, double spacing, std::uint32_t seed) {
    std::mt19937 random(seed);
    const double width = (nx - 1) * spacing;
    const double depth = (ny - 1) * spacing;
    struct Pocket {
        double x, y, w, d, angle, z;
    };
    std::vector<Pocket> pockets;
    for (int k = 0; k < 6; ++k)
        pockets.push_back({width * uniform(random), depth * uniform(random), 0.4 * width * uniform(random),
                           0.4 * depth * uniform(random), k % 2 == 0 ? 0 : 3.14159 * uniform(random),
                           -30 * uniform(random)});
    return fill(nx, ny, spacing, [&](double x, double y) {
        double z = 0;
        for (const Pocket& p : pockets) {
            const double u = std::cos(p.angle) * (x - p.x) + std::sin(p.angle) * (y - p.y);
            const double v = -std::sin(p.angle) * (x - p.x) + std::cos(p.angle) * (y - p.y);
            if (std::abs(u) <= p.w / 2 && std::abs(v) <= p.d / 2)
                z = std::min(z, p.z);
        }
        return z;
    });
}

Heights spheres(int nx, int ny, double spacing, std::uint32_t seed) {
    std::mt19937 random(seed);
    const double width = (nx - 1) * spacing;
    const double depth = (ny - 1) * spacing;
    struct Dent {
        double x, y, z, r;
    };
    std::vector<Dent> dents;
    for (int k = 0; k < 40; ++k)
        dents.push_back({width * uniform(random), depth * uniform(random), -2 * uniform(random),
                         5.5 * (0.5 + uniform(random))});
    return fill(nx, ny, spacing, [&](double x, double y) {
        double z = 0;
        for (const Dent& d : dents) {
            const double under = d.r * d.r - (x - d.x) * (x - d.x) - (y - d.y) * (y - d.y);
            if (under >= 0)
                z = std::min(z, d.z - std::sqrt(under));
        }
        return z;
    });
}

Heights noise(int nx, int ny, double spacing, std::uint32_t seed) {
    std::mt19937 random(seed);
    return fill(nx, ny, spacing, [&](double, double) { return -5 + 0.15 * uniform(random); });
}

} // namespace

std::span<const MapKind> mapKinds() {
    static const std::vector<MapKind> kinds{
        {"flat", flat}, {"terrain", terrain}, {"walls", walls}, {"spheres", spheres}, {"noise", noise}};
    return kinds;
}

const MapKind& mapKind(const std::string& name) {
    for (const MapKind& kind : mapKinds())
        if (kind.name == name)
            return kind;
    throw std::invalid_argument("no such map: " + name);
}

ZMapSnapshot zmapOf(int nx, int ny, double spacing, const Heights& heights) {
    const Grid grid{nx, ny, spacing, spacing, 0, 0};
    StockBox stock;
    stock.width = (nx - 1) * spacing;
    stock.depth = (ny - 1) * spacing;
    stock.height = 100;
    ZMap zmap(stock, grid);
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
            const int tile = (j / Tile::kSize) * zmap.tilesX() + i / Tile::kSize;
            zmap.tileForWriting(static_cast<std::size_t>(tile)).at(i % Tile::kSize, j % Tile::kSize) =
                heights[static_cast<std::size_t>(j) * static_cast<std::size_t>(nx) +
                        static_cast<std::size_t>(i)];
        }
    }
    return zmap.snapshot();
}

} // namespace proveout::test
