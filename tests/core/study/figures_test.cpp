// SPDX-License-Identifier: GPL-3.0-or-later
// The table of figures, and the paper's statements about its curves as far as counts can show them.
#include <algorithm>
#include <gtest/gtest.h>
#include <set>
#include <string>

#include "core/decimation/regions/region_decimator.h"
#include "core/study/figures.h"
#include "core/study/sweep.h"
#include "tests/core/simulation/programs.h"

namespace proveout {
namespace {

/// The figures are those of the paper, so they use its method, whatever the product's default.
StudySubject subjectOf(int blocks = 120) {
    DecimationParameters base;
    base.method = DecimationMethod::lee;
    useDefaults(base, false, false, 0);
    return {{programOf(randomProgram(8, blocks)), smallSetup()}, base, "Time"};
}

std::vector<StudyRun> runsOf(const StudySubject& subject, SweepKind kind) {
    const std::vector<SweepKind> kinds{kind};
    std::vector<StudyRun> runs;
    for (const StudyPoint& point : pointsOf(kinds, subject)) {
        auto run = runStudy(subject.job, point, nullptr);
        EXPECT_TRUE(run);
        runs.push_back(std::move(*run));
    }
    return runs;
}

const FigureRow& figure(const std::string& id) {
    return *std::ranges::find_if(figureTable(), [&](const FigureRow& row) { return row.id == id; });
}

TEST(Figures, EveryRowHasASweepAndAName) {
    std::set<std::string> ids;
    for (const FigureRow& row : figureTable()) {
        EXPECT_TRUE(ids.insert(row.id).second);
        EXPECT_TRUE(
            std::ranges::any_of(sweepTable(), [&](const SweepRow& s) { return s.kind == row.sweep; }));
        EXPECT_NE(*row.title, '\0');
    }
    // All figures of the paper that contain data.
    std::string papers;
    for (const FigureRow& row : figureTable())
        papers += std::string(" ") + row.paper + ",";
    for (const char* number : {" 7,", " 8,", " 9,", " 10,", " 11,", " 12,", " 14,", " 15,", " 16,"})
        EXPECT_NE(papers.find(number), std::string::npos) << number;
}

TEST(Figures, ChartsDrawEveryPointOfTheirSweepAndNothingBeforeIt) {
    const StudySubject subject = subjectOf(60);
    for (const FigureRow& row : figureTable()) {
        SCOPED_TRACE(row.id);
        for (const Curve& curve : row.chart(subject, {}).curves)
            EXPECT_TRUE(curve.points.empty());
        const Chart chart = row.chart(subject, runsOf(subject, row.sweep));
        EXPECT_FALSE(chart.curves.empty());
        EXPECT_FALSE(chart.xLabel.empty());
        EXPECT_FALSE(chart.yLabel.empty());
        for (const Curve& curve : chart.curves)
            EXPECT_FALSE(curve.points.empty()) << curve.label;
    }
}

TEST(Figures, PointsOfAllSweepsAreRunOnce) {
    const StudySubject subject = subjectOf(20);
    std::vector<SweepKind> kinds;
    std::size_t apart = 0;
    for (const SweepRow& row : sweepTable()) {
        kinds.push_back(row.kind);
        apart += row.points(subject).size();
    }
    const auto points = pointsOf(kinds, subject);
    EXPECT_LT(points.size(), apart) << "sweeps share the paper's standard point";
    for (std::size_t k = 0; k < points.size(); ++k)
        EXPECT_EQ(std::count(points.begin(), points.end(), points[k]), 1);
}

TEST(Figure9, FacesFallWithTheAllowanceFromARatioOfOne) {
    const StudySubject subject = subjectOf();
    const Chart chart = figure("fig09").chart(subject, runsOf(subject, SweepKind::allowance));
    const std::vector<Vec2>& faces = chart.curves.front().points;
    ASSERT_EQ(faces.size(), studiedAllowances().size());
    EXPECT_EQ(faces.front(), Vec2(0, 1));
    EXPECT_DOUBLE_EQ(chart.curves[1].points.front().y, 1);
    EXPECT_LT(faces.back().y, faces[1].y);
    for (const Vec2& point : faces)
        EXPECT_LE(point.y, 1);
}

TEST(Figure10, FacesAreLeastRightAfterAMoment) {
    const StudySubject subject = subjectOf();
    const Chart chart = figure("fig10").chart(subject, runsOf(subject, SweepKind::allowance));
    const std::vector<Vec2>& faces = chart.curves.back().points; // for the largest allowance
    ASSERT_EQ(faces.size(), 120U);
    for (std::size_t block = 20; block < faces.size(); block += 20)
        EXPECT_LE(faces[block - 1].y, faces[block - 2].y) << "block " << block;
    for (std::size_t k = 0; k + 1 < faces.size(); ++k) {
        if ((k + 2) % 20 !=
            0) { // between two decimations regions only become dirty; borders may hide a few triangles
            EXPECT_GE(faces[k + 1].y, faces[k].y - 1) << "block " << k + 2;
        }
    }
}

TEST(Figure12, FacesGrowWithThePeriodWhereOneDividesTheOther) {
    const StudySubject subject = subjectOf(200);
    const auto runs = runsOf(subject, SweepKind::period);
    const auto facesOf = [&](int period) {
        return std::ranges::find_if(runs,
                                    [&](const StudyRun& run) {
                                        return run.point.parameters.period == period &&
                                               run.point.parameters.allowance > 0;
                                    })
            ->count.faces;
    };
    // Every decimation of the longer period is also one of the shorter: the longer never has fewer dirty
    // regions.
    EXPECT_LT(facesOf(1), facesOf(5));
    EXPECT_LT(facesOf(5), facesOf(20));
    EXPECT_LT(facesOf(20), facesOf(100));
    EXPECT_LT(facesOf(100), facesOf(-1));
}

TEST(StudyVariants, HoldThePaperToTheLetterAndEveryLocalMethod) {
    const auto variants = studyVariants({});
    const auto letter = std::ranges::find(variants, "lee-paper", &StudyVariant::key);
    ASSERT_NE(letter, variants.end());
    EXPECT_EQ(letter->base.method, DecimationMethod::lee);
    EXPECT_FALSE(letter->base.certify);
    EXPECT_EQ(letter->base.borders, BorderRule::paper);
    for (const DecimationMethodRow& method : decimationMethods()) {
        const auto own =
            std::ranges::count_if(variants, [&](const auto& v) { return v.base.method == method.method; });
        const bool local = method.create != nullptr && !method.wholeMap;
        EXPECT_EQ(own, local ? 1 + (method.method == DecimationMethod::lee ? 1 : 0) : 0);
    }
}

TEST(StudiedRegions, StayWithinTheMap) {
    const auto regions = studiedRegions(subjectOf(1).job); // 80 × 60 cells
    EXPECT_EQ(regions.front(), 5);
    EXPECT_EQ(regions.back(), 64);
}

} // namespace
} // namespace proveout
