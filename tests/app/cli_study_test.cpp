// SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>
#include <gmock/gmock.h>
#include <sstream>

#include "tests/app/command_line.h"

namespace proveout {
namespace {

using testing::HasSubstr;
using testing::Not;

class CliStudy : public CommandLine {
protected:
    void SetUp() override { write("a.nc", kSound); }
    Finished study(const std::string& more) { return run("study a.nc" + kStock + kTool + more); }
    /// The lines of a table, without its header.
    std::size_t rows(const std::string& name) {
        std::istringstream text(read(name));
        std::size_t count = 0;
        for (std::string line; std::getline(text, line);)
            ++count;
        return count - 1;
    }
};

TEST_F(CliStudy, WritesTablesAndPicturesOfASweep) {
    const auto done = study("--method lee --sweep region --out here --json");
    ASSERT_EQ(done.exitCode, 0) << done.err;
    EXPECT_THAT(done.json()["files"], testing::ElementsAre("fig08-lee.csv", "fig08-lee.svg", "runs-lee.csv"));
    EXPECT_THAT(read("here/fig08-lee.svg"), HasSubstr("</svg>"));
    EXPECT_THAT(read("here/fig08-lee.csv"), HasSubstr("\"Region size, cells\""));
    // 10 sizes up to 64 of a map of 80 × 60 cells, 4 curves, and the run without decimation
    EXPECT_EQ(rows("here/runs-lee.csv"), 41U);
}

TEST_F(CliStudy, RunsEveryMethodWhereNoneIsNamed) {
    const auto done = study("--sweep period --out .");
    ASSERT_EQ(done.exitCode, 0) << done.err;
    EXPECT_TRUE(exists("fig12-lee-paper.svg"));
    EXPECT_TRUE(exists("fig12-lee.svg"));
}

TEST_F(CliStudy, AllSweepsGiveAllFigures) {
    const auto done = study("--method lee --sweep all --out all");
    ASSERT_EQ(done.exitCode, 0) << done.err;
    for (const char* id : {"fig02", "fig07", "fig08", "fig09", "fig10", "fig11", "fig12"})
        EXPECT_TRUE(exists("all/" + std::string(id) + "-lee.csv")) << id;
}

TEST_F(CliStudy, OptimisePrintsChoicePredictionAndMeasurement) {
    const auto done = study("--optimise --repeats 1 --json");
    ASSERT_EQ(done.exitCode, 0) << done.err;
    const auto json = done.json();
    EXPECT_GE(json["region"], 5);
    EXPECT_NE(json["period"], 0);
    EXPECT_GT(json["predictedSeconds"], 0);
    EXPECT_GT(json["measuredSeconds"], 0);
    EXPECT_GT(json["forecasts"].size(), 10U);
    const auto text = study("--optimise --repeats 1");
    EXPECT_THAT(text.out, HasSubstr("chosen"));
    EXPECT_THAT(text.out, HasSubstr("predicted"));
    EXPECT_THAT(text.out, HasSubstr("measured"));
}

TEST_F(CliStudy, ExhaustiveHoldsTheChoiceAgainstAllPoints) {
    const auto done = study("--optimise --exhaustive --repeats 1 --json");
    ASSERT_EQ(done.exitCode, 0) << done.err;
    EXPECT_GE(done.json()["exhaustive"]["chosenOverBest"], 1);
}

TEST_F(CliStudy, RefusesWhatMakesNoSense) {
    EXPECT_EQ(study("").exitCode, 3) << "neither --sweep nor --optimise";
    EXPECT_EQ(study("--sweep nonsense").exitCode, 3);
    EXPECT_EQ(study("--sweep region --optimise").exitCode, 3);
    EXPECT_EQ(study("--sweep region --repeats 0").exitCode, 3);
    EXPECT_EQ(study("--optimise --method none").exitCode, 3);
    EXPECT_EQ(study("--optimise --method global").exitCode, 3);
    EXPECT_EQ(run("study none.nc" + kStock + kTool + "--sweep region").exitCode, 3);
    write("file", "in the way");
    EXPECT_EQ(study("--sweep period --out file/below").exitCode, 3);
    const auto unwritable = study("--sweep period --out /sys"); // also unwritable for root
    EXPECT_EQ(unwritable.exitCode, 3);
    EXPECT_THAT(unwritable.err, Not(HasSubstr("runs"))) << "told before the runs, not after them";
}

TEST_F(CliStudy, ReportsWhatTheProgramHasWrong) {
    write("b.nc", "T1 M6\nG0 X5 Y5 Z5\nG1 Z-2\nM30\n"); // no feed rate
    EXPECT_EQ(run("study b.nc" + kStock + kTool + "--method lee --sweep period --out .").exitCode, 2);
    write("c.nc", "T7 M6\nG0 X5 Y5 Z5\nG1 Z-2 F100\nM30\n");
    EXPECT_THAT(run("study c.nc" + kStock + kTool + "--method lee --sweep period --out .").err,
                HasSubstr("c.nc:2:"))
        << "curves of a program of which nothing was cut";
}

TEST_F(CliStudy, RunsNothingWhereNothingMoves) {
    write("d.nc", "M30\n");
    const auto done = run("study d.nc" + kStock + kTool + "--sweep all --out empty");
    EXPECT_EQ(done.exitCode, 2);
    EXPECT_THAT(done.err, HasSubstr("[no-motion]"));
    EXPECT_FALSE(exists("empty"));
    EXPECT_EQ(run("study d.nc" + kStock + kTool + "--optimise").exitCode, 2);
}

} // namespace
} // namespace proveout
