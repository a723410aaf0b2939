// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/decimation/hard_maps.h"

#include <array>
#include <cmath>
#include <random>

namespace proveout::test {

namespace {

class Source {
public:
    explicit Source(std::uint32_t seed) : m_random(seed) {}
    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(m_random()) / 4294967296.0;
    }
    double logUniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
    int whole(int low, int high) { return low + static_cast<int>(m_random() % unsigned(high - low + 1)); }

private:
    std::mt19937 m_random;
};

using Field = void (*)(Source&, HardMap&);

template<class HeightAt>
void fill(HardMap& map, HeightAt&& heightAt) {
    map.heights.clear();
    for (int j = 0; j < map.ny; ++j)
        for (int i = 0; i < map.nx; ++i)
            map.heights.push_back(static_cast<float>(heightAt(i, j)));
}

void terrain(Source& random, HardMap& map) {
    struct Wave {
        double kx, ky, phase, height;
    };
    std::array<Wave, 6> waves{};
    for (Wave& wave : waves) {
        const double length = random.logUniform(3, 100);
        const double angle = random.uniform(0, 6.2832);
        wave = {std::cos(angle) * 6.2832 / length, std::sin(angle) * 6.2832 / length, random.uniform(0, 6),
                random.uniform(0, 0.01 * length)};
    }
    fill(map, [&](int i, int j) {
        double z = -20;
        for (const Wave& wave : waves)
            z += wave.height * std::sin(wave.kx * i + wave.ky * j + wave.phase);
        return z;
    });
}

void steps(Source& random, HardMap& map) {
    const double angle = random.uniform(0, 6.2832);
    const double width = random.uniform(1.5, 20);
    const double rise = random.logUniform(0.001, 5);
    fill(map, [&](int i, int j) {
        return -50 + rise * std::floor((std::cos(angle) * i + std::sin(angle) * j) / width);
    });
}

void spikes(Source& random, HardMap& map) {
    fill(map, [&](int, int) { return -30.0; });
    for (int k = random.whole(1, 20); k > 0; --k)
        map.heights[static_cast<std::size_t>(random.whole(0, map.nx * map.ny - 1))] =
            static_cast<float>(random.uniform(-100, 0));
}

/// Long thin ridges, one point wide.
void needles(Source& random, HardMap& map) {
    fill(map, [&](int i, int j) { return -40 + 0.01 * i + 0.003 * j; });
    for (int k = random.whole(1, 8); k > 0; --k) {
        double x = random.uniform(0, map.nx - 1);
        double y = random.uniform(0, map.ny - 1);
        const double angle = random.uniform(0, 6.2832);
        const double z = random.uniform(-80, -1);
        for (int step = random.whole(3, 120); step > 0; --step, x += std::cos(angle), y += std::sin(angle))
            if (x >= 0 && y >= 0 && x < map.nx && y < map.ny)
                map.heights[static_cast<std::size_t>(int(y) * map.nx + int(x))] = static_cast<float>(z);
    }
}

void walls(Source& random, HardMap& map) {
    fill(map, [&](int, int) { return 0.0; });
    for (int k = random.whole(1, 6); k > 0; --k) {
        const double x = random.uniform(0, map.nx);
        const double y = random.uniform(0, map.ny);
        const double r = random.uniform(2, 0.4 * std::max(map.nx, map.ny));
        const double z = random.uniform(-60, -1);
        const bool isRound = random.whole(0, 1) == 0;
        const double angle = random.uniform(0, 6.2832);
        for (int j = 0; j < map.ny; ++j) {
            for (int i = 0; i < map.nx; ++i) {
                const double u = std::cos(angle) * (i - x) + std::sin(angle) * (j - y);
                const double v = -std::sin(angle) * (i - x) + std::cos(angle) * (j - y);
                float& height = map.heights[static_cast<std::size_t>(j * map.nx + i)];
                if (isRound ? u * u + v * v < r * r : std::abs(u) < r && std::abs(v) < r / 2)
                    height = std::min(height, static_cast<float>(z));
            }
        }
    }
}

void noise(Source& random, HardMap& map) {
    const double height = random.logUniform(1e-4, 50);
    fill(map, [&](int, int) { return -50 + random.uniform(-height, height); });
}

void constant(Source& random, HardMap& map) {
    const double z = random.uniform(-100, 0);
    fill(map, [&](int, int) { return z; });
}

void plane(Source& random, HardMap& map) {
    const double a = random.uniform(-0.3, 0.3);
    const double b = random.uniform(-0.3, 0.3);
    fill(map, [&](int i, int j) { return -50 + a * i + b * j; });
}

/// Far from zero, where floats are coarse, and with unrealistically high cliffs.
void extremes(Source& random, HardMap& map) {
    const double base = random.uniform(-1, 1) * random.logUniform(1, 1e6);
    const double cliff = random.logUniform(1e-3, 1e6);
    const int at = random.whole(0, map.nx);
    fill(map, [&](int i, int j) {
        return base + (i < at ? 0 : cliff) + 0.05 * std::sin(0.3 * i) * std::sin(0.2 * j);
    });
}

} // namespace

HardMap hardMap(std::uint32_t seed, int most) {
    static constexpr std::array<std::pair<const char*, Field>, 9> kFields{{{"terrain", terrain},
                                                                           {"steps", steps},
                                                                           {"spikes", spikes},
                                                                           {"needles", needles},
                                                                           {"walls", walls},
                                                                           {"noise", noise},
                                                                           {"constant", constant},
                                                                           {"plane", plane},
                                                                           {"extremes", extremes}}};
    Source random(seed * 2654435761U + 1);
    HardMap map;
    map.nx = random.whole(2, random.whole(2, most));
    map.ny = random.whole(2, random.whole(2, most));
    const auto& [kind, make] = kFields[seed % kFields.size()];
    map.kind = kind;
    make(random, map);
    map.spacing = random.logUniform(0.01, 2);
    return map;
}

} // namespace proveout::test
