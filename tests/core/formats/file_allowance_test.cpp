// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/file_allowance.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>
#include <vector>

#include "core/base/argument.h"
#include "core/decimation/regions/region_decimator.h"
#include "core/decimation/solid/solid_error.h"
#include "core/decimation/surface/refined_surface.h"
#include "tests/core/decimation/random_triangulation.h"
#include "tests/core/formats/steep_maps.h"
#include "tests/core/temporary_folder.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

using testing::HasSubstr;

/// Of distanceFrom(), which computes differently.
constexpr double kRounding = 1e-9;

DecimationParameters promisedOf(double allowance) {
    DecimationParameters parameters;
    parameters.allowance = allowance;
    return parameters;
}

SolidForExport solidOf(const ZMapSnapshot& zmap, const DecimationParameters& parameters) {
    return {zmap, closeSolid(zmap, decimatedWhole(zmap, forExport(parameters)).releaseTriangles()),
            errorLevel(parameters)};
}

class FileAllowanceTest : public testing::Test {
protected:
    /// What every export does, into an STL file.
    struct Made {
        std::vector<double> allowances; ///< of each try
        Result<ExportedSolid> exported;
        double distance = 0; ///< of the file, as it was read again
    };
    Made make(const ZMapSnapshot& zmap, const DecimationParameters& promised) const {
        FileAllowance allowance(promised, CoordinateType::float32, zmap.stock());
        Made made;
        for (;;) {
            made.allowances.push_back(allowance.parameters().allowance);
            SolidForExport solid = solidOf(zmap, allowance.parameters());
            if (allowance.reduce(solid))
                continue;
            made.exported = allowance.check(file(), CoordinateType::float32).and_then([&] {
                return exportSolid(file(), *findFormat("stl")->meshWriter(), solid, promised);
            });
            made.distance = made.exported ? test::distanceFrom(zmap, *readStl(file())) : 0;
            return made;
        }
    }
    [[nodiscard]] std::filesystem::path file() const { return m_folder / "a.stl"; }

    TemporaryFolder m_folder;
};

/// Half a step of float32 is 3e-5 mm there, and the wave 10.8 times as steep: the reduction by the rounding
/// on slopes of 45° does not suffice.
TEST_F(FileAllowanceTest, ASteepWallFarFromTheOriginIsMadeForLess) {
    const ZMapSnapshot zmap = test::waveAt(700.3);
    const DecimationParameters promised = promisedOf(0.05);
    const FileAllowance first(promised, CoordinateType::float32, zmap.stock());
    SolidForExport once = solidOf(zmap, first.parameters());
    ASSERT_TRUE(exportSolid(file(), *findFormat("stl")->meshWriter(), once, promised));
    EXPECT_GT(test::distanceFrom(zmap, *readStl(file())), 0.05) << "nothing to reduce: proves nothing";

    const Made made = make(zmap, promised);
    ASSERT_TRUE(made.exported) << oneLine(made.exported.error().front());
    EXPECT_GT(made.allowances.size(), 1U);
    EXPECT_LE(made.exported->largestErrorMm, 0.05);
    EXPECT_LE(made.distance, 0.05 + kRounding);
    EXPECT_GT(made.exported->largestErrorMm, 0.045) << "more triangles than necessary";
    EXPECT_TRUE(made.exported->warnings.empty());
}

TEST_F(FileAllowanceTest, NearTheOriginTheFirstMeshIsTheLast) {
    const Made made = make(test::waveAt(0.1), promisedOf(0.05));
    EXPECT_EQ(made.allowances.size(), 1U);
    EXPECT_LE(made.distance, 0.05 + kRounding);
}

/// The step of float32 is 1/128 mm there.
TEST_F(FileAllowanceTest, WallsTooSteepForTheRoundingAreRefusedWithFigures) {
    const ZMapSnapshot zmap = test::waveAt(80'000.3);
    const Made made = make(zmap, promisedOf(0.05));
    ASSERT_FALSE(made.exported);
    const Diagnostic& refused = made.exported.error().front();
    EXPECT_STREQ(refused.id, "export-rounding-too-large");
    EXPECT_EQ(refused.severity, Severity::error);
    EXPECT_EQ(refused.file, file().string());
    EXPECT_THAT(message(refused), HasSubstr("of the error allowance of 0.05 mm"));
    EXPECT_THAT(hintText(refused), HasSubstr(".obj .ply .3mf"));
    EXPECT_FALSE(std::filesystem::exists(file()));
    const double rounding = std::stod(refused.arguments.at(0));
    EXPECT_GT(rounding, 0.025);
    EXPECT_LE(rounding, (11 + 1) / 256.0) << "half a step, and the slope";

    const Made larger = make(zmap, promisedOf(std::stod(refused.arguments.at(2))));
    ASSERT_TRUE(larger.exported) << "the allowance that the message asks for: "
                                 << oneLine(larger.exported.error().front());
    EXPECT_LE(larger.distance, std::stod(refused.arguments.at(2)) + kRounding);
    FileAllowance allowance(promisedOf(0.05), CoordinateType::float64, zmap.stock());
    SolidForExport solid = solidOf(zmap, allowance.parameters());
    EXPECT_FALSE(allowance.reduce(solid));
    EXPECT_TRUE(allowance.check("a.ply", CoordinateType::float64));
}

TEST_F(FileAllowanceTest, RoundingBeyondHalfOfTheAllowanceIsRefusedBeforeTheWork) {
    const StockBox stock{{2000, 300, 0}, 100, 100, 20};
    // Half the steps of float32: 2^-13 from 2048 mm for X, 2^-16 below 512 mm for Y, 2^-20 for Z.
    const double rounding = std::ldexp(1, -13) + std::ldexp(1, -16) + std::ldexp(1, -20);
    const auto refused = [&](DecimationParameters promised, CoordinateType type = CoordinateType::float32) {
        return !checkRounding("a.stl", type, promised, stock).has_value();
    };
    EXPECT_FALSE(refused(promisedOf(2 * rounding)));
    DecimationParameters tiny = promisedOf(1.99 * rounding);
    EXPECT_TRUE(refused(tiny));
    const auto result = checkRounding("a.stl", CoordinateType::float32, tiny, stock);
    const Diagnostic& reason = result.error().front();
    EXPECT_STREQ(reason.id, "export-rounding-too-large");
    EXPECT_NEAR(std::stod(reason.arguments.at(0)), rounding, 1e-7);
    EXPECT_GE(std::stod(reason.arguments.at(2)), 2 * rounding);
    EXPECT_LE(std::stod(reason.arguments.at(2)), 2.2 * rounding);
    EXPECT_FALSE(refused(promisedOf(std::stod(reason.arguments.at(2)))));
    EXPECT_FALSE(refused(tiny, CoordinateType::float64));
    EXPECT_FALSE(refused(promisedOf(0))) << "nothing was promised";
    tiny.method = DecimationMethod::none;
    EXPECT_FALSE(refused(tiny)) << "a full mesh cannot be made for less";
    tiny.method = DecimationMethod::lee;
    EXPECT_TRUE(refused(tiny)) << "it has a bound";
    tiny.certify = false;
    EXPECT_FALSE(refused(tiny)) << "it has no bound";
}

TEST_F(FileAllowanceTest, TheFirstAllowanceIsLessByTheRounding) {
    const DecimationParameters promised = promisedOf(0.05);
    const StockBox stock{{0, 0, 0}, 100, 100, 20};
    EXPECT_EQ(FileAllowance(promised, CoordinateType::float64, stock).parameters(), promised);
    // Half the steps of float32: 2^-18 below 128 mm for X and Y, 2^-20 below 32 mm for Z.
    EXPECT_NEAR(FileAllowance(promised, CoordinateType::float32, stock).parameters().allowance,
                0.05 - std::ldexp(1, -18) - std::ldexp(1, -18) - std::ldexp(1, -20), 1e-15);
    DecimationParameters unbounded = promised;
    unbounded.method = DecimationMethod::lee;
    unbounded.certify = false;
    EXPECT_EQ(FileAllowance(unbounded, CoordinateType::float32, stock).parameters(), unbounded);
}

TEST_F(FileAllowanceTest, AFullMeshIsWrittenWithAWarning) {
    DecimationParameters full = promisedOf(0.02);
    full.method = DecimationMethod::none;
    const Made made = make(test::waveAt(80'000.3), full);
    EXPECT_EQ(made.allowances.size(), 1U);
    ASSERT_TRUE(made.exported);
    ASSERT_EQ(made.exported->warnings.size(), 1U);
    EXPECT_STREQ(made.exported->warnings.front().id, "export-rounded-beyond");
}

/// What is written is within the allowance; what is refused needs more than half of it for the rounding.
TEST_F(FileAllowanceTest, WhatIsWrittenKeepsTheAllowanceAnywhere) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    const auto between = [&random](double low, double high) {
        return std::exp(std::uniform_real_distribution<double>(std::log(low), std::log(high))(random));
    };
    int reduced = 0;
    int refused = 0;
    for (int round = 0; round < roundsOf(60); ++round) {
        SCOPED_TRACE(round);
        const Vec3 corner(between(1, 1e5), -between(1, 1e5), between(1, 1000));
        const ZMapSnapshot zmap =
            round % 2 == 0 ? test::waveAt(corner.x, between(0.1, 12))
                           : test::pocketsAt(corner, between(0.05, 1), static_cast<std::uint32_t>(random()));
        DecimationParameters promised = promisedOf(between(0.002, 0.3));
        promised.level = round % 3 == 0 ? ErrorLevel::sample : ErrorLevel::surface;
        const auto fits = checkRounding(file(), CoordinateType::float32, promised, zmap.stock());
        const Made made = make(zmap, promised);
        EXPECT_LE(made.allowances.size(), static_cast<std::size_t>(FileAllowance::kMostTries));
        EXPECT_TRUE(std::ranges::is_sorted(made.allowances, std::ranges::greater()));
        EXPECT_GE(made.allowances.back(), promised.allowance / 2);
        reduced += made.allowances.size() > 1 && made.exported ? 1 : 0;
        if (made.exported) {
            EXPECT_LE(made.exported->largestErrorMm, promised.allowance);
            if (promised.level == ErrorLevel::surface) {
                EXPECT_LE(made.distance, promised.allowance + kRounding);
            }
            continue;
        }
        ++refused;
        EXPECT_STREQ(made.exported.error().front().id, "export-rounding-too-large");
        const TriangleMesh full = closeSolid(zmap, test::fullTriangulation(zmap.grid().nx, zmap.grid().ny));
        const double ofFullMesh = measureSolidError(zmap, full, CoordinateType::float32, ErrorLevel::surface);
        EXPECT_TRUE(!fits || ofFullMesh > promised.allowance / 4)
            << "every point of the grid, rounded: " << ofFullMesh << " of " << promised.allowance;
    }
    if (roundsOf(60) == 60) {
        EXPECT_GT(reduced, 0) << "nothing was made again: the test proves little";
        EXPECT_GT(refused, 0);
    }
}

/// Two holes through a high stock that meet at a grid point: its two copies are apart by 1e-4 mm in plan, on
/// walls with a slope of 2000, so the mesh deviates by 0.2 mm whatever it is made for.
TEST_F(FileAllowanceTest, PartsThatAreSetApartAreAWarningInEveryFormat) {
    const ZMapSnapshot zmap = test::mapAt({0, 0, 0}, 1, 1, 0.0125, [](int i, int j) {
        const bool hole =
            (i >= 20 && i <= 40 && j >= 20 && j <= 40) || (i >= 40 && i <= 60 && j >= 40 && j <= 60);
        return hole ? -25.0 : 0.0;
    });
    const DecimationParameters promised = promisedOf(0.05);
    const Made made = make(zmap, promised);
    EXPECT_EQ(made.allowances.size(), 1U) << "less would not help";
    ASSERT_TRUE(made.exported);
    EXPECT_GT(made.exported->largestErrorMm, 0.05);
    ASSERT_EQ(made.exported->warnings.size(), 1U);
    EXPECT_STREQ(made.exported->warnings.front().id, "export-set-apart");
    SolidForExport solid = solidOf(zmap, promised);
    const auto ply = exportSolid(m_folder / "a.ply", *findFormat("ply")->meshWriter(), solid, promised);
    ASSERT_EQ(ply->warnings.size(), 1U);
    EXPECT_STREQ(ply->warnings.front().id, "export-set-apart");
}

TEST_F(FileAllowanceTest, WallsAtPointsOfTheGridAreCounted) {
    const ZMapSnapshot zmap = test::mapAt({0, 0, 0}, 1, 1, 0.05, [](int, int) { return -1.0; });
    const DecimationParameters promised = promisedOf(0.05);
    SolidForExport solid = solidOf(zmap, promised);
    const auto plain = exportSolid(m_folder / "a.stl", *findFormat("stl")->meshWriter(), solid, promised);
    EXPECT_TRUE(plain->warnings.empty());
    solid.setWallPoints(12); // and the map has none left
    const auto noted = exportSolid(m_folder / "a.stl", *findFormat("stl")->meshWriter(), solid, promised);
    ASSERT_EQ(noted->warnings.size(), 1U);
    EXPECT_STREQ(noted->warnings.front().id, "export-walls-on-grid");
    EXPECT_EQ(message(noted->warnings.front()).substr(0, 28), "12 of 12 points beside walls");
}

TEST_F(FileAllowanceTest, TheProgressOfAllTriesRises) {
    const ZMapSnapshot zmap = test::waveAt(20'000.3, 5);
    FileAllowance allowance(promisedOf(0.05), CoordinateType::float32, zmap.stock());
    std::vector<double> reported;
    const WorkContext whole{{}, [&](double done) { reported.push_back(done); }};
    bool again = true;
    int tries = 0;
    while (again) {
        ++tries;
        const WorkContext part = allowance.thisTry(whole);
        part.report(0);
        SolidForExport solid = solidOf(zmap, allowance.parameters());
        again = allowance.reduce(solid, part.part(0.5, 1));
        part.report(1);
    }
    EXPECT_GT(tries, 1);
    EXPECT_TRUE(std::ranges::is_sorted(reported));
    EXPECT_LE(reported.back(), 1);
    EXPECT_GE(reported.back(), 0.9);
}

TEST_F(FileAllowanceTest, AStopEndsTheTries) {
    const ZMapSnapshot zmap = test::waveAt(700.3);
    FileAllowance allowance(promisedOf(0.05), CoordinateType::float32, zmap.stock());
    SolidForExport solid = solidOf(zmap, allowance.parameters());
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(allowance.reduce(solid, {stop.get_token(), {}}));
    EXPECT_TRUE(allowance.reduce(solid)) << "what was stopped is measured again";
}

} // namespace
} // namespace proveout
