// SPDX-License-Identifier: GPL-3.0-or-later
// Decimation of a whole map on one thread: triangles in per second, the remaining triangles, and the measured
// error, by map, region size, allowance and `certify`. Maps: those of the tests, 1001 × 1001 points at 0.1
// mm, or any z-map file named by PROVEOUT_BENCH_ZMAP (NPY, spacing in PROVEOUT_BENCH_GRID).
#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

#include <cstdlib>
#include <map>
#include <string>

#include "core/decimation/regions/error_measure.h"
#include "core/decimation/surface/surface.h"
#include "core/formats/npy.h"
#include "tests/core/decimation/maps.h"

namespace {

using namespace proveout;

constexpr int kPoints = 1001;

const ZMapSnapshot& generatedMap(const std::string& name) {
    static std::map<std::string, ZMapSnapshot> maps;
    if (!maps.contains(name))
        maps[name] = test::zmapOf(kPoints, kPoints, 0.1, test::mapKind(name).make(kPoints, kPoints, 0.1, 17));
    return maps.at(name);
}

void decimate(benchmark::State& state, const ZMapSnapshot& zmap) {
    const tbb::global_control oneThread(tbb::global_control::max_allowed_parallelism, 1);
    DecimationParameters parameters;
    parameters.regionCells = static_cast<int>(state.range(0));
    parameters.allowance = static_cast<double>(state.range(1)) / 1000;
    parameters.certify = state.range(2) != 0;
    const Grid& grid = zmap.grid();
    SurfaceSnapshot decimated;
    for (auto _ : state) {
        Surface surface(grid.nx, grid.ny, parameters);
        surface.decimateDirty(zmap);
        decimated = surface.snapshot();
    }
    const VerticalError error =
        measureVerticalError(zmap, {0, 0, grid.nx, grid.ny}, decimated.triangles(), parameters.allowance);
    const auto facesIn = static_cast<double>(decimated.facesFull);
    state.counters["triIn"] = benchmark::Counter(facesIn, benchmark::Counter::kIsIterationInvariantRate);
    state.counters["faces%"] = 100 * static_cast<double>(decimated.faces) / facesIn;
    state.counters["errorMm"] = error.largest;
    state.counters["beyond%"] =
        100 * static_cast<double>(error.beyond) / (static_cast<double>(grid.nx) * grid.ny);
}

void sweep(benchmark::internal::Benchmark* bench) {
    bench->ArgNames({"region", "allowanceUm", "certify"})
        ->ArgsProduct({{8, 16, 64}, {10, 50, 100}, {0, 1}})
        ->Unit(benchmark::kMillisecond);
}

void generated(benchmark::State& state, const std::string& name) {
    decimate(state, generatedMap(name));
}

void fromFile(benchmark::State& state) {
    const char* file = std::getenv("PROVEOUT_BENCH_ZMAP");
    const char* spacing = std::getenv("PROVEOUT_BENCH_GRID");
    if (file == nullptr || spacing == nullptr)
        return state.SkipWithError("PROVEOUT_BENCH_ZMAP and PROVEOUT_BENCH_GRID name no map");
    static const Result<NpyArray> array = readNpy(file);
    if (!array)
        return state.SkipWithError("the map cannot be read");
    static const ZMapSnapshot zmap = test::zmapOf(array->columns, array->rows, std::atof(spacing),
                                                  test::Heights(array->values.begin(), array->values.end()));
    decimate(state, zmap);
}

BENCHMARK_CAPTURE(generated, flat, "flat")->Apply(sweep);
BENCHMARK_CAPTURE(generated, terrain, "terrain")->Apply(sweep);
BENCHMARK_CAPTURE(generated, walls, "walls")->Apply(sweep);
BENCHMARK_CAPTURE(generated, spheres, "spheres")->Apply(sweep);
BENCHMARK(fromFile)->Apply(sweep);

} // namespace
