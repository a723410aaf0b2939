// SPDX-License-Identifier: GPL-3.0-or-later
// The command check with a design part.
#include <array>
#include <fmt/format.h>
#include <string>
#include <vector>

#include "tests/app/command_line.h"

namespace proveout {
namespace {

const std::string kOptions = " --accept holder-not-given,shank-not-given,fixtures-not-given,travel-not-given,"
                             "machine-not-given,tool-limits-not-given --stock 60x40x15 --grid 0.25 "
                             "--tool 1=flat:d=8,l=20 --tool 2=flat:d=4,l=20 ";

/// A pocket of 30 × 20 mm, 4 mm deep, with corners of the radius of the tool, in steps of 4 mm.
std::string pocket(const std::string& planted = {}, const std::string& end = {}) {
    return "G21 G90 G17\nT1 M6\nS5000 M3\nG0 X19 Y14 Z5\nG1 Z-4 F200\n" // to line 5
           "X41 F600\nY18\nX19\nY22\nX41\nY26\nX19\nY14\nX41\nY26\n" +  // to line 15
           planted +
           "G0 Z5\n" + end + "M5\nM30\n";
}

/// ASCII STL of boxes from (lo) to (hi).
std::string boxes(const std::vector<std::array<double, 6>>& all) {
    std::string text = "solid part\n";
    constexpr std::array<std::array<int, 3>, 12> kFacets{{{0, 2, 1},
                                                          {1, 2, 3},
                                                          {4, 5, 6},
                                                          {5, 7, 6},
                                                          {0, 1, 4},
                                                          {1, 5, 4},
                                                          {2, 6, 3},
                                                          {3, 6, 7},
                                                          {0, 4, 2},
                                                          {2, 4, 6},
                                                          {1, 3, 5},
                                                          {3, 7, 5}}};
    for (const auto& box : all)
        for (const auto& facet : kFacets) {
            text += "facet normal 0 0 0\nouter loop\n";
            for (const int corner : facet)
                text += fmt::format("vertex {} {} {}\n", (corner & 1) != 0 ? box[3] : box[0],
                                    (corner & 2) != 0 ? box[4] : box[1], (corner & 4) != 0 ? box[5] : box[2]);
            text += "endloop\nendfacet\n";
        }
    return text + "endsolid part\n";
}

class CliPart : public CommandLine {
protected:
    /// The solid that a program leaves becomes the part.
    std::string partOf(const std::string& program) {
        write("design.nc", program);
        const Finished made = run("simulate design.nc --stock 60x40x15 --grid 0.25 --tool 1=flat:d=8,l=20 "
                                  "--tool 2=flat:d=4,l=20 --allowance 0.001 --export part.stl");
        EXPECT_EQ(made.exitCode, 0) << made.err;
        return "part.stl";
    }
    Finished check(const std::string& program, const std::string& more) {
        return run("check " + write("prog.nc", program) + kOptions + "--json " + more);
    }
};

TEST_F(CliPart, AProgramThatMakesThePartIsSafe) {
    partOf(pocket());
    const Finished done = check(pocket(), "--part part.stl --tolerance 0.01");
    EXPECT_EQ(done.exitCode, 0) << done.out << done.err;
    const nlohmann::json part = done.json()["part"];
    EXPECT_EQ(part["gouges"], 0);
    EXPECT_EQ(part["excesses"], 0);
    EXPECT_EQ(part["points"], 241 * 161);
    EXPECT_EQ(done.json()["verdict"], "safe");
}

TEST_F(CliPart, PlantedGougesHaveTheirBlocksAndTools) {
    partOf(pocket());
    // Into the floor, into the wall, and a hole by another tool beside the pocket, right through.
    const std::string planted = "X30 Y20\nZ-4.5 F100\nZ-4\nX41.2\nX30\n";         // lines 16 to 20
    const std::string hole = "T2 M6\nS5000 M3\nG0 X52 Y8\nG1 Z-15 F100\nG0 Z5\n"; // lines 22 to 26
    const Finished done = check(pocket(planted, hole), "--part part.stl --tolerance 0.1,0.1");
    EXPECT_EQ(done.exitCode, 1) << done.out << done.err;
    const nlohmann::json islands = done.json()["part"]["islands"];
    ASSERT_EQ(islands.size(), 3U) << islands.dump(1);
    const auto has = [&](std::size_t k, double depth, double within, int line, int tool) {
        const nlohmann::json& island = islands[k];
        EXPECT_EQ(island["kind"], "gouge");
        EXPECT_NEAR(island["depthMm"].get<double>(), depth, within);
        EXPECT_EQ(island["line"], line);
        EXPECT_EQ(island["tool"], tool);
    };
    has(0, 2, 0.25, 25, 2); // its middle is a radius away from what is left
    has(1, 0.5, 1e-3, 17, 1);
    has(2, 0.2, 0.005, 19, 1); // the wall stands where its rim is, not on the grid
    EXPECT_NEAR(islands[0]["volumeMm3"].get<double>(), 3.14159 * 4 * 15, 25); // without what is in tolerance
    EXPECT_NEAR(islands[1]["volumeMm3"].get<double>(), 3.14159 * 16 * 0.5, 1);
    EXPECT_EQ(islands[1]["place"][2], -4.5);
    // One finding for each kind and tool, at the first line of its blocks.
    std::vector<std::string> gouges;
    const nlohmann::json result = done.json();
    for (const nlohmann::json& finding : result["findings"])
        if (finding["id"] == "gouge")
            gouges.push_back(fmt::format("T{} {} {}", finding["tool"].get<int>(), finding["line"].get<int>(),
                                         finding["count"].get<int>()));
    EXPECT_EQ(gouges, (std::vector<std::string>{"T2 25 1", "T1 17 2"}));
    EXPECT_EQ(check(pocket(planted, hole), "--part part.stl --tolerance 0.1 --rules gouge=off").exitCode, 0);
}

TEST_F(CliPart, WhatIsLeftIsToldWithItsReason) {
    partOf(pocket());
    std::string shallow = pocket();
    shallow.replace(shallow.find("Z-4"), 3, "Z-3.7");
    const Finished left = check(shallow, "--part part.stl --tolerance 0.1");
    EXPECT_EQ(left.exitCode, 1);
    ASSERT_GE(left.json()["part"]["islands"].size(), 1U) << left.out;
    EXPECT_EQ(left.json()["part"]["islands"][0]["kind"], "excess");
    EXPECT_NEAR(left.json()["part"]["islands"][0]["depthMm"].get<double>(), 0.3, 1e-3);
    EXPECT_EQ(check(shallow, "--part part.stl --tolerance 0.1,0.31").exitCode, 0);
    EXPECT_EQ(check(shallow, "--part allowance=0.3,file=part.stl --tolerance 0.4").exitCode, 0);

    write("nothing.nc", "G21 G90 G17\nT1 M6\nS5000 M3\nG0 X5 Y5 Z5\nG1 Z-0.05 F100\nG0 Z5\nM5\nM30\n");
    const Finished uncut = run("check nothing.nc" + kOptions + "--json --part part.stl --tolerance 0.1");
    EXPECT_EQ(uncut.exitCode, 1);
    const nlohmann::json island = uncut.json()["part"]["islands"][0];
    EXPECT_EQ(island["kind"], "excess");
    EXPECT_EQ(island["uncut"], true);
    EXPECT_NEAR(island["depthMm"].get<double>(), 4, 1e-3);
    EXPECT_NEAR(island["volumeMm3"].get<double>(), (30 * 20 - (4 - 3.14159) * 16) * 4, 50)
        << "points on its wall count as whole cells";
}

TEST_F(CliPart, APartThatCannotBeComparedLeavesTheProgramUnverified) {
    write("open.stl", "solid x\n");
    EXPECT_EQ(check(pocket(), "--part open.stl").exitCode, 2);
    EXPECT_EQ(check(pocket(), "--part none.stl").exitCode, 2);
    write("inch.stl", boxes({{0, 0, -0.5, 2.36, 1.57, 0}}));
    EXPECT_EQ(check(pocket(), "--part scale=25.4,file=inch.stl").exitCode, 1)
        << "the pocket is a gouge of it";
    write("far.stl", boxes({{100, 100, -10, 160, 140, 0}}));
    const Finished far = check(pocket(), "--part far.stl");
    EXPECT_EQ(far.exitCode, 2);
    EXPECT_NE(far.err.find("part-misplaced"), std::string::npos) << far.err;
    write("wide.stl", boxes({{-1, 0, -15, 60, 40, 0}}));
    EXPECT_NE(check(pocket(), "--part wide.stl").err.find("reaches 1.000 mm beyond the stock (−X)"),
              std::string::npos);
    EXPECT_EQ(check(pocket(), "--tolerance 0.1").exitCode, 3) << "there is no part";
    EXPECT_EQ(check(pocket(), "--part part.stl --tolerance x").exitCode, 3);
    const Finished noStock =
        run("check " + write("prog.nc", pocket()) + " --tool 1=flat:d=8 --part wide.stl --json");
    EXPECT_NE(noStock.err.find("part-unread"), std::string::npos) << noStock.err;
}

/// A ledge with a recess below it: the tool cannot reach what is left there, and it is no excess.
TEST_F(CliPart, AnUndercutIsANote) {
    write("ledge.stl", boxes({{0, 0, -15, 60, 40, -8}, {0, 0, -8, 50, 40, -4}, {0, 0, -4, 60, 40, 0}}));
    const Finished done =
        check("G21 G90 G17\nT1 M6\nS5000 M3\nG0 X30 Y20 Z5\nG1 Z-0.05 F100\nG0 Z5\nM5\nM30\n",
              "--part ledge.stl --tolerance 0.1");
    EXPECT_NE(done.err.find("part-undercut"), std::string::npos) << done.err;
    EXPECT_EQ(done.json()["part"]["excesses"], 0) << done.json()["part"]["islands"].dump(1);
}

TEST_F(CliPart, AJobNamesItsPart) {
    partOf(pocket());
    write("prog.nc", pocket());
    const auto job = [&](const std::string& part) {
        return write("part.proveout", R"({"proveout": 2, "program": "prog.nc", "grid": 0.25,
            "stock": {"width": 60, "depth": 40, "height": 15}, "tools": {"1": "flat:d=8,l=20"}, "part": )" +
                                          part + "}");
    };
    const Finished done =
        run("check " + job(R"({"file": "part.stl", "below": 0.02, "above": 0.05})") + " --json");
    EXPECT_EQ(done.json()["part"]["tolerance"]["below"], 0.02);
    EXPECT_EQ(done.json()["part"]["gouges"], 0);
    EXPECT_EQ(done.json()["inputs"].size(), 3U) << "the part is an input, with its digest";
    EXPECT_EQ(run("check " + job(R"({"below": 0.02})")).exitCode, 3) << "without a file";
    EXPECT_EQ(run("check " + job(R"({"file": "part.stl", "below": -1})")).exitCode, 3);
    EXPECT_EQ(run("check " + job(R"({"file": "../../elsewhere.stl"})")).exitCode, 3)
        << "outside of its folder";
}

} // namespace
} // namespace proveout
