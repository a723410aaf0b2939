// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/solid_export.h"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>

#include "core/decimation/solid/solid_error.h"
#include "core/decimation/surface/surface.h"
#include "tests/core/decimation/random_triangulation.h"
#include "tests/core/formats/steep_maps.h"
#include "tests/core/temporary_folder.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

using testing::HasSubstr;

constexpr double kAllowance = 0.05;

TriangleMesh decimated(const ZMapSnapshot& zmap, double allowance = kAllowance) {
    DecimationParameters parameters;
    parameters.allowance = allowance;
    Surface surface(zmap.grid().nx, zmap.grid().ny, parameters);
    surface.decimateDirty(zmap);
    return closeSolid(zmap, surface.snapshot().triangles());
}

class SolidExport : public testing::Test {
protected:
    Result<ExportedSolid> exportTo(const std::string& name, const ZMapSnapshot& zmap,
                                   const TriangleMesh& solid, double allowance = kAllowance,
                                   const WorkContext& context = {}) {
        const auto file = m_folder / name;
        SolidForExport mesh(zmap, solid, ErrorLevel::sample);
        DecimationParameters promised;
        promised.allowance = allowance;
        return exportSolid(file, *meshFormatOf(file).value()->meshWriter(), mesh, promised, context);
    }

    TemporaryFolder m_folder;
};

TEST_F(SolidExport, TheErrorReportedIsThatOfTheFile) {
    for (const double far : {0.1, 700.3, 20'000.7}) {
        const ZMapSnapshot zmap = test::waveAt(far);
        const TriangleMesh solid = decimated(zmap);
        const auto stl = exportTo("a.stl", zmap, solid);
        ASSERT_TRUE(stl) << oneLine(stl.error().front());
        const auto back = readStl(m_folder / "a.stl");
        ASSERT_TRUE(back);
        EXPECT_EQ(stl->file.triangles, back->triangles.size());
        EXPECT_EQ(measureSolidError(zmap, *back, CoordinateType::float32, ErrorLevel::sample),
                  stl->largestErrorMm)
            << far;
        EXPECT_EQ(exportTo("a.ply", zmap, solid)->largestErrorMm,
                  measureSolidError(zmap, solid, CoordinateType::float64, ErrorLevel::sample))
            << far;
    }
}

TEST_F(SolidExport, NearTheOriginRoundingIsNothing) {
    const ZMapSnapshot zmap = test::waveAt(0.1);
    const TriangleMesh solid = decimated(zmap);
    const auto stl = exportTo("a.stl", zmap, solid);
    EXPECT_LE(stl->largestErrorMm, kAllowance);
    EXPECT_TRUE(stl->warnings.empty());
    EXPECT_NEAR(stl->largestErrorMm, exportTo("a.obj", zmap, solid)->largestErrorMm, 1e-4);
}

/// The step of float32 is 1/128 mm there, and the wave is ten times as steep.
TEST_F(SolidExport, RoundingBeyondTheAllowanceIsAWarningThatOffersDoubles) {
    const ZMapSnapshot zmap = test::waveAt(80'000.3);
    const TriangleMesh solid = decimated(zmap);
    const auto stl = exportTo("a.stl", zmap, solid);
    ASSERT_TRUE(stl) << oneLine(stl.error().front());
    EXPECT_GT(stl->largestErrorMm, kAllowance);
    ASSERT_EQ(stl->warnings.size(), 1U);
    const Diagnostic& warning = stl->warnings.front();
    EXPECT_STREQ(warning.id, "export-rounded-beyond");
    EXPECT_EQ(warning.severity, Severity::warning);
    EXPECT_THAT(hintText(warning), HasSubstr("double precision: .obj .ply"));
    EXPECT_EQ(warning.file, (m_folder / "a.stl").string());
    EXPECT_THAT(
        message(warning),
        HasSubstr("more than the error allowance of 0.05 mm; a format in double precision would keep 0.0"));
    for (const char* exact : {"a.obj", "a.ply", "a.3mf"}) {
        const auto other = exportTo(exact, zmap, solid);
        EXPECT_LE(other->largestErrorMm, kAllowance) << exact;
        EXPECT_TRUE(other->warnings.empty()) << exact;
    }
}

/// "0.05 mm, beyond 0.05 mm" would be useless.
TEST_F(SolidExport, TheFiguresOfTheWarningDiffer) {
    const ZMapSnapshot zmap = test::waveAt(700.3);
    const TriangleMesh solid = decimated(zmap);
    const double exact = exportTo("a.ply", zmap, solid)->largestErrorMm;
    const double rounded = exportTo("a.stl", zmap, solid)->largestErrorMm;
    ASSERT_GT(rounded, exact);
    ASSERT_LT(rounded, exact + 1e-3);
    const auto stl = exportTo("a.stl", zmap, solid, exact);
    ASSERT_EQ(stl->warnings.size(), 1U);
    const auto& figures = stl->warnings.front().arguments;
    EXPECT_GT(std::stod(figures[0]), std::stod(figures[1])) << message(stl->warnings.front());
}

TEST_F(SolidExport, WhereRoundingIsNotToBlameThereIsNoWarning) {
    const ZMapSnapshot zmap = test::waveAt(80'000.3);
    const TriangleMesh coarse = decimated(zmap, 0.5);
    EXPECT_GT(exportTo("a.ply", zmap, coarse)->largestErrorMm, kAllowance);
    EXPECT_TRUE(exportTo("a.stl", zmap, coarse)->warnings.empty());
    EXPECT_TRUE(exportTo("a.stl", zmap, decimated(zmap), 0)->warnings.empty()) << "nothing was promised";
}

/// Pinched, cut through, decimated at random into long slivers: as long as the step of float32 is far below
/// the spacing, it stays a valid solid.
TEST_F(SolidExport, StlTakesEverySolidOfUsualSize) {
    const unsigned seed = randomSeed();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto upTo = [&random](double size) {
        return std::uniform_real_distribution<double>(-size, size)(random);
    };
    int written = 0;
    for (int round = 0; round < 150; ++round) {
        const int nx = 2 + static_cast<int>(random() % 30);
        const int ny = 2 + static_cast<int>(random() % 30);
        const double spacing = 0.05 * (1 + static_cast<double>(random() % 20));
        const StockBox stock{{upTo(500), upTo(500), upTo(500)}, spacing * (nx - 1), spacing * (ny - 1), 40};
        ZMap zmap(stock, Grid{nx, ny, spacing, spacing, stock.corner.x, stock.corner.y});
        Tile& tile = zmap.tileForWriting(0);
        const unsigned percentOnFloor = 20 * static_cast<unsigned>(random() % 4);
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i)
                tile.at(i, j) = random() % 100 < percentOnFloor ? -40 : static_cast<float>(-20 + upTo(20));
        tile.refreshMaximum();
        const ZMapSnapshot moment = zmap.snapshot();
        const TriangleMesh solid =
            closeSolid(moment, test::randomTriangulation(nx, ny, random() % 1000, random));
        if (solid.triangles.empty())
            continue;
        const auto stl = exportTo("a.stl", moment, solid);
        ASSERT_TRUE(stl) << "round " << round << ": " << oneLine(stl.error().front());
        ++written;
    }
    EXPECT_GT(written, 100);
}

TEST_F(SolidExport, ProgressRisesToOneAndAWishToStopLeavesNoFile) {
    const ZMapSnapshot zmap = test::waveAt(80'000.3);
    const TriangleMesh solid = decimated(zmap, 0.001);
    for (const double stopAt : {2.0, 0.0, 0.25, 0.5}) {
        std::stop_source stop;
        std::vector<double> reported;
        WorkContext context;
        context.stop = stop.get_token();
        context.progress = [&](double done) {
            reported.push_back(done);
            if (done >= stopAt)
                stop.request_stop();
        };
        const auto result = exportTo("a.stl", zmap, solid, 0.001, context);
        EXPECT_TRUE(std::ranges::is_sorted(reported));
        EXPECT_EQ(result.has_value(), stopAt > 1) << stopAt;
        EXPECT_EQ(m_folder.entries(), stopAt > 1 ? 1U : 0U);
        if (result)
            EXPECT_EQ(reported.back(), 1);
        else
            EXPECT_STREQ(result.error().front().id, "cancelled");
        std::filesystem::remove(m_folder / "a.stl");
    }
}

} // namespace
} // namespace proveout
