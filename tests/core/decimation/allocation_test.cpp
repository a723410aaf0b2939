// SPDX-License-Identifier: GPL-3.0-or-later
// "Data storage for winged edge data is allocated in the first step, and then used repeatedly" (paper §4.1).
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <malloc.h>
#include <new>
#include <numeric>
#include <random>
#include <string>

#include "core/decimation/certified/certified_border.h"
#include "core/decimation/certified/certified_decimator.h"
#include "core/decimation/lee/lee_decimator.h"
#include "core/decimation/solid/solid.h"
#include "core/decimation/surface/map_memory.h"
#include "core/decimation/surface/refined_surface.h"
#include "tests/core/decimation/maps.h"

namespace {
std::atomic<std::size_t> allocations{0};
std::atomic<std::size_t> bytesHeld{0};
std::atomic<std::size_t> bytesPeak{0};

void count(std::size_t bytes) {
    const std::size_t held = bytesHeld += bytes;
    std::size_t peak = bytesPeak;
    while (peak < held && !bytesPeak.compare_exchange_weak(peak, held)) {
    }
}
} // namespace

// noinline, because GCC would report a mismatched pair if only one of them was inlined.
[[gnu::noinline]] void* operator new(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size == 0 ? 1 : size)) {
        count(malloc_usable_size(memory));
        return memory;
    }
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
    bytesHeld -= malloc_usable_size(memory);
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
    operator delete(memory);
}

namespace proveout {
namespace {

TEST(LeeDecimator, allocatesNothingPerRegionButTheTrianglesItGives) {
    const RegionGrid grid(65, 65, 64);
    const IndexRect rect = grid.points(0);
    LeeDecimator decimator;
    std::vector<test::Heights> maps;
    for (const auto& kind : test::mapKinds())
        maps.push_back(kind.make(65, 65, 0.5, 4));
    // The first region of each kind makes the storage grow.
    for (const test::Heights& heights : maps)
        (void)decimator.decimate(grid, {rect, 0.5, 0.5, heights}, {}, 1, {});
#ifndef NDEBUG
    GTEST_SKIP() << "OpenMesh's assertions allocate";
#endif
    for (const test::Heights& heights : maps) {
        const std::size_t before = allocations;
        const RegionMesh mesh = decimator.decimate(grid, {rect, 0.5, 0.5, heights}, {}, 1, {});
        EXPECT_EQ(allocations - before, 1U);
        EXPECT_FALSE(mesh.triangles.empty());
    }
}

TEST(CertifiedDecimator, allocatesNothingPerRegionButTheTrianglesItGives) {
    const RegionGrid grid(65, 65, 64);
    const IndexRect rect = grid.points(0);
    DecimationParameters parameters;
    parameters.method = DecimationMethod::certified;
    CertifiedDecimator decimator;
    std::vector<std::uint32_t> all(65);
    std::iota(all.begin(), all.end(), 0U);
    const auto line = std::make_shared<const BorderLine>(BorderLine{all, {}});
    const std::array<BorderLinePtr, 4> borders{line, line, line, line};
    for (const bool isFirst : {true, false}) { // the first round makes the storage grow
        for (const auto& kind : test::mapKinds()) {
            const test::Heights heights = kind.make(65, 65, 0.5, 4);
            const std::size_t before = allocations;
            const RegionMesh mesh =
                decimator.decimate(grid, {rect, 0.5, 0.5, heights}, borders, 1, parameters);
            EXPECT_FALSE(mesh.triangles.empty());
            if (!isFirst) {
                EXPECT_EQ(allocations - before, 1U) << kind.name;
            }
        }
    }
}

/// The maximum of the bytes held in addition to those held before.
double peakOf(const auto& work) {
    const std::size_t before = bytesHeld;
    bytesPeak = before;
    work();
    return static_cast<double>(bytesPeak - before);
}

/// The worst cases for the memory of a solid's full mesh: points on the floor next to points above it.
struct FloorPattern {
    const char* name;
    bool (*isAbove)(int i, int j, std::mt19937& random);
};
constexpr std::array kFloorPatterns{
    FloorPattern{"above everywhere", [](int, int, std::mt19937&) { return true; }},
    FloorPattern{"one hole",
                 [](int i, int j, std::mt19937&) { return i < 200 || i > 300 || j < 200 || j > 300; }},
    FloorPattern{"holes", [](int i, int j, std::mt19937&) { return i % 20 > 4 || j % 20 > 4; }},
    FloorPattern{"every other", [](int i, int j, std::mt19937&) { return (i + j) % 2 == 1; }},
    FloorPattern{"diamonds", [](int i, int j, std::mt19937&) { return j % 2 == 1 && i % 2 == 0; }},
    FloorPattern{"squares",
                 [](int i, int j, std::mt19937&) { return i % 2 == 1 && j % 2 == 1 && (i + j) % 4 == 0; }},
    FloorPattern{"stripes", [](int i, int, std::mt19937&) { return i % 3 == 0; }},
    FloorPattern{"half", [](int, int, std::mt19937& random) { return random() % 2 == 0; }},
    FloorPattern{"a third", [](int, int, std::mt19937& random) { return random() % 3 == 0; }},
    FloorPattern{"most of every other",
                 [](int i, int j, std::mt19937& random) { return (i + j) % 2 == 1 && random() % 4 != 0; }},
    FloorPattern{"half of every other",
                 [](int i, int j, std::mt19937& random) { return (i + j) % 2 == 1 && random() % 2 != 0; }},
};

TEST(MapMemory, IsNoLessThanSolidsTake) {
    constexpr int kSize = 501;
    DecimationParameters none;
    none.method = DecimationMethod::none;
    // The measurement also counts memory that is reserved but not used yet.
    constexpr double kMostOfForecast = 1.2;
    const double most =
        kMostOfForecast * kSize * kSize * meshBytesPerPoint(none, {.schedule = false, .solid = true});
    for (const FloorPattern& pattern : kFloorPatterns) {
        std::mt19937 random(1);
        test::Heights heights;
        for (int j = 0; j < kSize; ++j)
            for (int i = 0; i < kSize; ++i)
                heights.push_back(pattern.isAbove(i, j, random) ? -1.0F : -100.0F);
        const ZMapSnapshot zmap = test::zmapOf(kSize, kSize, 0.1, heights);
        const double peak = peakOf([&] {
            const TriangleMesh solid =
                closeSolid(zmap, Surface(kSize, kSize, none).snapshot().releaseTriangles());
            EXPECT_GT(solid.triangles.size(), 0U);
        });
        EXPECT_LE(peak, most) << pattern.name << ", bytes a point: " << peak / (kSize * kSize);
        RecordProperty(std::string("bytes a point, ") + pattern.name, std::to_string(peak / (kSize * kSize)));
    }
}

TEST(MapMemory, IsNoLessThanSurfacesTake) {
    constexpr int kSize = 501;
    for (const auto& kind : test::mapKinds()) {
        const ZMapSnapshot zmap = test::zmapOf(kSize, kSize, 0.1, kind.make(kSize, kSize, 0.1, 3));
        for (const int region : {8, 16}) {
            SCOPED_TRACE(kind.name + ", region " + std::to_string(region));
            DecimationParameters parameters;
            parameters.regionCells = region;
            Surface cut(kSize, kSize, whileCutting(parameters));
            const double cutting = peakOf([&] { (void)cut.decimateDirty(zmap); });
            EXPECT_LE(cutting, kSize * kSize * meshBytesPerPoint(parameters, {}));
            const double whole = peakOf([&] { (void)decimatedWhole(zmap, parameters); });
            EXPECT_LE(whole,
                      1e7 + kSize * kSize * meshBytesPerPoint(parameters, {.schedule = false, .whole = true}))
                << "10 MB: what the decimators work with";
            const double atRest = peakOf([&] {
                RefinedSurface refined(kSize, kSize, parameters);
                EXPECT_TRUE(refined.follow(zmap, {}));
            });
            EXPECT_LE(atRest, bytesAtRest(parameters, zmap.grid(), cut.faces()));
        }
    }
}

} // namespace
} // namespace proveout
