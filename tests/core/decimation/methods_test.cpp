// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>
#include <type_traits>

#include "core/decimation/surface/surface.h"
#include "tests/core/decimation/maps.h"

namespace proveout {
namespace {

/// Gives one field a different value.
void change(DecimationParameters& parameters, std::string_view key) {
    describe(parameters, [key](auto& value, const Field& field) {
        using Value = std::remove_cvref_t<decltype(value)>;
        if (key != field.key)
            return;
        if constexpr (std::is_same_v<Value, bool>)
            value = !value;
        else if constexpr (std::is_enum_v<Value>)
            value = static_cast<Value>(static_cast<int>(value) == 0 ? 1 : 0);
        else
            value = static_cast<Value>(value * 2 + 1);
    });
}

std::vector<LatticeTriangle> decimated(const DecimationParameters& parameters) {
    constexpr int kSize = 61;
    const ZMapSnapshot zmap =
        test::zmapOf(kSize, kSize, 0.3, test::mapKind("spheres").make(kSize, kSize, 0.3, 12));
    Surface surface(kSize, kSize, parameters);
    surface.decimateDirty(zmap);
    std::vector<LatticeTriangle> triangles = surface.snapshot().triangles();
    std::sort(triangles.begin(), triangles.end()); // the regions that the triangles come from do not matter
    return triangles;
}

/// The panel offers the fields that the row of a method names. Other fields must have no effect, and those
/// fields must have one; the period does not apply to a single decimation.
TEST(Methods, lookAtTheFieldsOfTheirRowAndAtNoOthers) {
    for (const DecimationMethodRow& method : decimationMethods()) {
        DecimationParameters parameters;
        parameters.method = method.method;
        useDefaults(parameters, false, false, 0);
        const auto before = decimated(parameters);
        describe(parameters, [&](const auto&, const Field& field) {
            const std::string_view key = field.key;
            if (key == "method" || key == "period")
                return;
            DecimationParameters other = parameters;
            change(other, key);
            EXPECT_EQ(decimated(other) != before, method.uses(key))
                << kMethodChoices[static_cast<std::size_t>(method.method)].key << ", " << key;
        });
    }
}

TEST(Methods, defaultRegionsGrowWithTheMapSoThatTheirNumberDoesNot) {
    for (const DecimationMethodRow& method : decimationMethods()) {
        SCOPED_TRACE(kMethodChoices[static_cast<std::size_t>(method.method)].key);
        EXPECT_EQ(defaultRegion(method.method, 0), method.defaultRegion);
        EXPECT_EQ(defaultRegion(method.method, 1e6), method.defaultRegion);
        int last = method.defaultRegion;
        for (double points = 1e6; points < 3e9; points *= 1.1) {
            const int cells = defaultRegion(method.method, points);
            EXPECT_TRUE(cells == last || cells == 2 * last) << points;
            EXPECT_TRUE(points <= kMostDefaultRegions * static_cast<double>(cells * cells) ||
                        cells == kLargestDefaultRegion)
                << points;
            EXPECT_TRUE(cells == method.defaultRegion ||
                        points > kMostDefaultRegions * static_cast<double>(cells * cells) / 4)
                << points << ": no larger than it must be";
            last = cells;
        }
        EXPECT_EQ(last, kLargestDefaultRegion);
    }
}

TEST(Methods, aRegionSizeThatWasNamedStaysOnAnyMap) {
    DecimationParameters parameters;
    parameters.regionCells = 16;
    useDefaults(parameters, true, false, 2e8);
    EXPECT_EQ(parameters.regionCells, 16);
    useDefaults(parameters, false, false, 2e8);
    EXPECT_EQ(parameters.regionCells, 128);
}

} // namespace
} // namespace proveout
