// SPDX-License-Identifier: GPL-3.0-or-later
// The command check with a design part.
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "tests/app/command_line.h"

namespace proveout {
namespace {

const std::string kAccept = " --accept holder-not-given,shank-not-given,fixtures-not-given,travel-not-given,"
                            "machine-not-given,tool-limits-not-given ";
const std::string kOptions = kAccept + "--stock 60x40x15 --grid 0.25 "
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
    EXPECT_NEAR(islands[0]["volumeMm3"].get<double>(), 3.14159 * 4 * 15, 35); // without what is in tolerance
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

/// Between the points of a coarse grid the swept volumes decide, not the straight lines of the map.
TEST_F(CliPart, AnExactProgramIsRightOnACoarseGridWithAnyCutter) {
    const std::string program = "G21 G90 G17\nT1 M6\nS5000 M3\nG0 X-9 Y9.3 Z5\nG1 Z-4 F200\nX29 F600\nG0 Z5\n"
                                "G0 X8.6 Y-9\nG1 Z-2.5\nX13.1 Y29\nG0 Z5\nM5\nM30\n";
    write("prog.nc", program);
    for (const char* tool :
         {"flat:d=6,l=20", "bull:d=6,r=1,l=20", "ball:d=6,l=20", "cone:d=6,angle=40,tip=0,l=20"}) {
        const std::string setup = fmt::format(" --stock 20x20x8 --tool 1={} ", tool);
        ASSERT_EQ(
            run("simulate prog.nc" + setup + "--grid 0.05 --allowance 0.002 --export exact.stl").exitCode, 0);
        const Finished done = run("check prog.nc" + setup + kAccept +
                                  "--rules loose-piece=off --grid 0.5 --part exact.stl --tolerance 0.05");
        EXPECT_EQ(done.exitCode, 0) << tool << '\n' << done.out << done.err;
    }
}

/// A box with a round hole through it, whose wall leans by `lean` towards the top.
std::string holeThrough(double radiusAtTop, double radiusAtBottom) {
    constexpr int kSides = 96;
    std::string text = "solid hole\n";
    const auto facet = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const Vec3& at : {a, b, c})
            text += fmt::format("vertex {:.9g} {:.9g} {:.9g}\n", at.x, at.y, at.z);
        text += "endloop\nendfacet\n";
    };
    const auto quad = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        facet(a, b, c);
        facet(a, c, d);
    };
    const auto inner = [&](int k, double z) {
        const double angle = 2 * std::numbers::pi * k / kSides;
        const double radius = z == 0 ? radiusAtTop : radiusAtBottom;
        return Vec3(10 + radius * std::cos(angle), 10 + radius * std::sin(angle), z);
    };
    const auto outer = [&](int k, double z) { // on the square
        const double angle = 2 * std::numbers::pi * k / kSides;
        const Vec2 way(std::cos(angle), std::sin(angle));
        const Vec2 at = Vec2(10, 10) + way * (10 / std::max(std::abs(way.x), std::abs(way.y)));
        return Vec3(at, z);
    };
    for (int k = 0; k < kSides; ++k) {
        quad(inner(k, 0), outer(k, 0), outer(k + 1, 0), inner(k + 1, 0));
        quad(inner(k, -8), inner(k + 1, -8), outer(k + 1, -8), outer(k, -8));
        quad(inner(k, 0), inner(k + 1, 0), inner(k + 1, -8), inner(k, -8));
        quad(outer(k, 0), outer(k, -8), outer(k + 1, -8), outer(k + 1, 0));
    }
    return text + "endsolid hole\n";
}

/// Faults that the points of the grid do not see.
TEST_F(CliPart, WhatIsLeftInAHoleIsFoundHoweverItsWallLeans) {
    write("hole.stl", holeThrough(3, 3));
    write("lean.stl", holeThrough(3, 3.001));
    write("lip.stl", holeThrough(2.99, 3));
    const auto drilled = [&](double depth, const char* part) {
        write("drill.nc",
              fmt::format("G21 G90 G17\nT1 M6\nS5000 M3\nG0 X10 Y10 Z5\nG1 Z-{} F200\nG0 Z5\nM5\nM30\n",
                          depth));
        return run(
            "check drill.nc --stock 20x20x8 --tool 1=flat:d=6,l=20 --grid 0.5 --tolerance 0.05 --part " +
            std::string(part) + kAccept + "--rules loose-piece=off,table-collision=off --json");
    };
    EXPECT_EQ(drilled(8, "hole.stl").exitCode, 0);
    for (const char* part : {"hole.stl", "lean.stl", "lip.stl"}) {
        EXPECT_EQ(drilled(2, part).exitCode, 1) << part;
        const Finished skin = drilled(7.75, part);
        EXPECT_EQ(skin.exitCode, 1) << part;
        EXPECT_EQ(skin.json()["part"]["islands"][0]["line"], 5);
    }
}

TEST_F(CliPart, AnUncutChamferIsFoundBetweenThePoints) {
    // A box whose upper edge at the front is broken by 0.4 mm.
    write("chamfer.stl", [] {
        std::string text = "solid c\n";
        const std::array<Vec2, 5> outline{{{0, -8}, {20, -8}, {20, 0}, {0.4, 0}, {0, -0.4}}}; // y, z
        const auto facet = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
            text += "facet normal 0 0 0\nouter loop\n";
            for (const Vec3& at : {a, b, c})
                text += fmt::format("vertex {} {} {}\n", at.x, at.y, at.z);
            text += "endloop\nendfacet\n";
        };
        for (std::size_t k = 0; k < outline.size(); ++k) {
            const Vec2 from = outline[k];
            const Vec2 to = outline[(k + 1) % outline.size()];
            facet({0, from.x, from.y}, {0, to.x, to.y}, {20, to.x, to.y});
            facet({0, from.x, from.y}, {20, to.x, to.y}, {20, from.x, from.y});
            if (k > 0 && k + 1 < outline.size()) {
                facet({20, outline[0].x, outline[0].y}, {20, from.x, from.y}, {20, to.x, to.y});
                facet({0, outline[0].x, outline[0].y}, {0, to.x, to.y}, {0, from.x, from.y});
            }
        }
        return text + "endsolid c\n";
    }());
    write("touch.nc", "G21 G90 G17\nT1 M6\nS5000 M3\nG0 X10 Y15 Z5\nG1 Z-0.02 F200\nG0 Z5\nM5\nM30\n");
    const Finished done =
        run("check touch.nc --stock 20x20x8 --tool 1=flat:d=6,l=20 --grid 0.5 --tolerance 0.05 "
            "--part chamfer.stl --rules nothing-cut=off --json" +
            kAccept);
    EXPECT_EQ(done.exitCode, 1) << done.out << done.err;
    const nlohmann::json islands = done.json()["part"]["islands"];
    ASSERT_GE(islands.size(), 1U);
    EXPECT_EQ(islands[0]["kind"], "excess");
    EXPECT_GT(islands[0]["depthMm"].get<double>(), 0.15);
    EXPECT_LT(islands[0]["depthMm"].get<double>(), 0.3);
}

TEST_F(CliPart, WhatIsNotSeenIsUnverified) {
    write("flat.stl", boxes({{0, 0, -8, 20, 20, -3}}));
    // A ridge of 0.1 mm is left between two passes.
    write("ridge.nc",
          "G21 G90 G17\nT1 M6\nS5000 M3\nG0 X-9 Y3.2 Z5\nG1 Z-3 F200\nX29 F600\nG0 Z5\nG0 X-9 Y9.3\n"
          "G1 Z-3\nX29\nY15.2\nX-9\nY17.5\nX29\nG0 Z5\nG0 X-9 Y2\nG1 Z-3\nX29\nG0 Z5\nM5\nM30\n");
    const std::string command =
        "check ridge.nc --stock 20x20x8 --tool 1=flat:d=6,l=20 --grid 0.5 --tolerance 0.05 "
        "--part flat.stl --rules loose-piece=off" +
        kAccept;
    const Finished ridge = run(command);
    EXPECT_EQ(ridge.exitCode, 2) << ridge.out << ridge.err;
    EXPECT_NE(ridge.err.find("part-ribs-unseen"), std::string::npos) << ridge.err;
    std::string open = boxes({{0, 0, -15, 60, 40, 0}});
    open.erase(open.rfind("facet"), open.rfind("endfacet") + 9 - open.rfind("facet normal"));
    write("open.stl", open);
    const Finished cut = check("G21 G90 G17\nT1 M6\nS5000 M3\nG0 X5 Y5 Z5\nG1 Z-0.05 F100\nG0 Z5\nM5\nM30\n",
                               "--part open.stl --tolerance 0.1 --rules nothing-cut=off");
    EXPECT_EQ(cut.exitCode, 2) << cut.err;
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
