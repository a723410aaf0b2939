// SPDX-License-Identifier: GPL-3.0-or-later
// The certified decimation of whole maps on one thread: triangles left, triangles in per second of CPU time
// (fastest of several runs, including borders and reading of the z-map), and the true error, by map,
// allowance and level; for comparison meshoptimizer, region by region with locked borders, if it is
// installed.
//
//     certified_bench [MAP.npy SPACING]…     without maps: those of the tests
#ifdef PROVEOUT_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif
#include <tbb/global_control.h>
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "core/decimation/surface/refined_surface.h"
#include "core/decimation/surface/surface.h"
#include "core/formats/npy.h"
#include "tests/core/decimation/surface_oracle.h"

namespace {

using namespace proveout;

constexpr int kRegion = 64;

struct BenchMap {
    std::string name;
    int nx = 0;
    int ny = 0;
    double spacing = 0.1;
    test::Heights heights;
};

double cpuSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template<class Work>
double leastSeconds(int runs, Work&& work) {
    double least = std::numeric_limits<double>::infinity();
    for (int run = 0; run < runs; ++run) {
        const double begin = cpuSeconds();
        work();
        least = std::min(least, cpuSeconds() - begin);
    }
    return least;
}

double trianglesIn(const BenchMap& map) {
    return 2.0 * (map.nx - 1) * (map.ny - 1);
}

/// Seconds of meshoptimizer's simplifier only, without preparing its input.
double meshoptimizerSeconds([[maybe_unused]] const BenchMap& map, [[maybe_unused]] double allowance,
                            [[maybe_unused]] std::size_t& faces) {
#ifdef PROVEOUT_MESHOPTIMIZER
    const RegionGrid grid(map.nx, map.ny, kRegion);
    double seconds = 0;
    std::vector<unsigned> indices;
    std::vector<unsigned> simplified;
    std::vector<float> points;
    faces = 0;
    for (std::size_t region = 0; region < grid.regionCount(); ++region) {
        const IndexRect rect = grid.points(region);
        points.clear();
        for (int j = rect.j0; j < rect.j1; ++j)
            for (int i = rect.i0; i < rect.i1; ++i)
                points.insert(points.end(),
                              {static_cast<float>((i - rect.i0) * map.spacing),
                               static_cast<float>((j - rect.j0) * map.spacing),
                               map.heights[static_cast<std::size_t>(j) * static_cast<std::size_t>(map.nx) +
                                           static_cast<std::size_t>(i)]});
        indices.clear();
        for (const LatticeTriangle& triangle : fullRegionMesh(grid, region))
            for (const std::uint32_t v : triangle) {
                const int i = static_cast<int>(v % static_cast<std::uint32_t>(map.nx)) - rect.i0;
                const int j = static_cast<int>(v / static_cast<std::uint32_t>(map.nx)) - rect.j0;
                indices.push_back(static_cast<unsigned>(j * rect.width() + i));
            }
        simplified.resize(indices.size());
        const std::size_t count = points.size() / 3;
        const double begin = cpuSeconds();
        const float scale = meshopt_simplifyScale(points.data(), count, 12);
        faces +=
            meshopt_simplify(simplified.data(), indices.data(), indices.size(), points.data(), count, 12, 0,
                             static_cast<float>(allowance) / scale, meshopt_SimplifyLockBorder, nullptr) /
            3;
        seconds += cpuSeconds() - begin;
    }
    return seconds;
#else
    return 0;
#endif
}

void reportRefined(const BenchMap& map, const ZMapSnapshot& zmap, double allowance) {
    DecimationParameters parameters;
    parameters.method = DecimationMethod::certified;
    parameters.regionCells = kRegion;
    parameters.allowance = allowance;
    SurfaceSnapshot shown;
    const double seconds = leastSeconds(3, [&] {
        RefinedSurface surface(map.nx, map.ny, parameters);
        (void)surface.follow(zmap, {});
        shown = surface.snapshot();
    });
    const test::SurfaceDistance error = test::surfaceDistance(map.nx, map.ny, map.heights, shown.triangles());
    std::printf("%-8s %5.2f %-7s %8zu faces %8.1f Mtri/s  at points %.5f  surface %.5f\n", map.name.c_str(),
                allowance, "merged", shown.faces, trianglesIn(map) / seconds * 1e-6, error.samples,
                error.surface);
}

/// The time, on one thread, until regions touched by a cut of 200 × 200 points can be drawn again, for
/// positions all over the map.
void reportCuts(const BenchMap& map, const ZMapSnapshot& zmap, int region) {
    constexpr int kCut = 200;
    DecimationParameters parameters;
    parameters.regionCells = region;
    parameters.level = ErrorLevel::sample;
    Surface surface(map.nx, map.ny, parameters);
    surface.decimateDirty(zmap);
    std::vector<double> milliseconds;
    for (int j = 0; j + kCut < map.ny; j += kCut / 2)
        for (int i = 0; i + kCut < map.nx; i += kCut / 2) {
            surface.touch({i, j, i + kCut, j + kCut});
            const double begin = cpuSeconds();
            surface.decimateDirty(zmap);
            milliseconds.push_back((cpuSeconds() - begin) * 1e3);
        }
    if (milliseconds.empty())
        return;
    std::sort(milliseconds.begin(), milliseconds.end());
    std::printf("%-8s %5.2f a cut of %d x %d points, regions of %d: median %.2f ms, 99 %% within %.2f ms\n",
                map.name.c_str(), parameters.allowance, kCut, kCut, region,
                milliseconds[milliseconds.size() / 2], milliseconds[milliseconds.size() * 99 / 100]);
}

void report(const BenchMap& map) {
    const ZMapSnapshot zmap = test::zmapOf(map.nx, map.ny, map.spacing, map.heights);
    for (const double allowance : {0.05, 0.01}) {
        std::size_t theirFaces = 0;
        const double theirs = meshoptimizerSeconds(map, allowance, theirFaces);
        for (const ErrorLevel level : {ErrorLevel::sample, ErrorLevel::surface}) {
            DecimationParameters parameters;
            parameters.method = DecimationMethod::certified;
            parameters.regionCells = kRegion;
            parameters.allowance = allowance;
            parameters.level = level;
            Surface surface(map.nx, map.ny, parameters);
            const double seconds = leastSeconds(7, [&] {
                surface.touch({0, 0, map.nx, map.ny});
                surface.decimateDirty(zmap);
            });
            const test::SurfaceDistance error =
                test::surfaceDistance(map.nx, map.ny, map.heights, surface.snapshot().triangles());
            std::printf("%-8s %5.2f %-7s %8zu faces %8.1f Mtri/s  at points %.5f  surface %.5f",
                        map.name.c_str(), allowance, level == ErrorLevel::sample ? "sample" : "surface",
                        surface.faces(), trianglesIn(map) / seconds * 1e-6, error.samples, error.surface);
            if (theirs > 0)
                std::printf("  | meshoptimizer %8zu faces %5.1f Mtri/s, %.1f times slower", theirFaces,
                            trianglesIn(map) / theirs * 1e-6, theirs / seconds);
            std::printf("\n");
        }
        reportRefined(map, zmap, allowance);
    }
    for (const int region : {16, 64})
        reportCuts(map, zmap, region);
}

} // namespace

int main(int argc, char** argv) {
    const tbb::global_control oneThread(tbb::global_control::max_allowed_parallelism, 1);
    for (int k = 1; k + 1 < argc; k += 2) {
        const Result<NpyArray> array = readNpy(argv[k]);
        if (!array) {
            std::fprintf(stderr, "%s cannot be read.\n", argv[k]);
            return 1;
        }
        report({std::filesystem::path(argv[k]).stem().string(), array->columns, array->rows,
                std::atof(argv[k + 1]), test::Heights(array->values.begin(), array->values.end())});
    }
    if (argc == 1)
        for (const char* kind : {"flat", "terrain", "walls", "spheres"})
            report({kind, 1001, 1001, 0.1, test::mapKind(kind).make(1001, 1001, 0.1, 17)});
    return 0;
}
