// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <map>
#include <numbers>
#include <sstream>

#include "core/formats/npy.h"
#include "core/formats/stl.h"
#include "core/simulation/records/block_statistic.h"
#include "tests/app/command_line.h"

namespace proveout {
namespace {

using testing::HasSubstr;

class CliSimulate : public CommandLine {
protected:
    void SetUp() override { write("p.nc", kSound); }
    Finished simulate(const std::string& more) { return run("simulate p.nc" + kStock + kTool + more); }

    std::vector<std::vector<std::string>> records(const std::string& name) {
        std::vector<std::vector<std::string>> rows;
        std::istringstream lines(read(name));
        for (std::string line; std::getline(lines, line);) {
            rows.emplace_back();
            std::istringstream cells(line + ','); // the last cell may be empty
            for (std::string cell; std::getline(cells, cell, ',');)
                rows.back().push_back(cell);
        }
        return rows;
    }
};

/// Half of the cutter is beside the stock: its wall is between the points next to the border and the ones
/// behind them.
TEST_F(CliSimulate, WallsAlongTheBorderCountInTheVolume) {
    write("around.nc",
          "G21 G90 G17\nT1 M6\nS5000 M3\nG0 X0 Y0 Z5\nG1 Z-3 F200\nX40 F600\nY30\nX0\nY0\nG0 Z5\nM30\n");
    const nlohmann::json json =
        run("simulate around.nc --stock 40x30x10 --grid 1 --tool 1=flat:d=3,l=20 --json").json();
    const double exact = 3 * (40.0 * 30 - 37.0 * 27);
    EXPECT_NEAR(json["removedMm3"].get<double>(), exact, 0.005 * exact);
}

TEST_F(CliSimulate, ALargeMapHasLargerRegionsUnlessTheirSizeIsGiven) {
    const std::string large =
        "simulate p.nc --stock 220x220x10 --grid 0.1 --json" + kTool; // 2201 × 2201 points
    EXPECT_EQ(run(large).json()["regions"], 69 * 69);
    EXPECT_EQ(run(large + "--region 16").json()["regions"], 138 * 138);
    write("large.proveout", R"({"proveout": 1, "program": "p.nc", "tools": {"1": "ball:d=4,l=20"}, "grid": 1,
                                "stock": {"width": 220, "depth": 220, "height": 10}})");
    EXPECT_EQ(run("simulate --job large.proveout --grid 0.1 --json").json()["regions"], 69 * 69)
        << "the job names none";
    write("named.proveout", R"({"proveout": 1, "program": "p.nc", "tools": {"1": "ball:d=4,l=20"}, "grid": 1,
                                "stock": {"width": 220, "depth": 220, "height": 10},
                                "decimation": {"region": 16}})");
    EXPECT_EQ(run("simulate --job named.proveout --grid 0.1 --json").json()["regions"], 138 * 138);
}

TEST_F(CliSimulate, ReportsTheTimeOfTheMachine) {
    write("p.nc", "T1 M6\nG0 X0 Y0 Z5\nG1 X600 F600\nG4 P2\nG0 X0\nM30\n");
    const auto assumed = simulate("--start 0,0,5 --json").json()["machineSeconds"];
    EXPECT_EQ(assumed["assumed"], true);
    EXPECT_EQ(assumed["dwell"], 2.0);
    EXPECT_NEAR(assumed["feed"], 60, 0.1);
    const auto described = simulate("--start 0,0,5 --json --machine "
                                    "rapidXY=6000,accelerationXY=500,toolChange=4")
                               .json()["machineSeconds"];
    EXPECT_EQ(described["assumed"], false);
    EXPECT_EQ(described["toolChange"], 4.0);
    EXPECT_NEAR(described["rapid"], 6 + 0.2, 1e-9);
    EXPECT_NEAR(described["total"].get<double>(), described["executed"].get<double>(), 1e-9);
    const auto wrong = simulate("--machine speed=3");
    EXPECT_EQ(wrong.exitCode, 3);
    EXPECT_THAT(wrong.err, HasSubstr("A machine has no \"speed\""));
}

TEST_F(CliSimulate, WritesTheSourceLineThatCutEachPoint) {
    const auto done = simulate("--provenance lines.npy --until 3");
    ASSERT_EQ(done.exitCode, 0) << done.err;
    const std::string bytes = read("lines.npy");
    ASSERT_THAT(bytes, HasSubstr("'descr': '<u4', 'fortran_order': False, 'shape': (61, 81)"));
    const auto lineAt = [&](int i, int j) {
        std::uint32_t line = 0;
        const std::size_t data = bytes.size() - std::size_t{61} * 81 * sizeof line;
        std::memcpy(&line, bytes.data() + data + static_cast<std::size_t>(j * 81 + i) * sizeof line,
                    sizeof line);
        return line;
    };
    EXPECT_EQ(lineAt(10, 10), 4U) << "the plunge";
    EXPECT_EQ(lineAt(40, 10), 5U) << "the groove";
    EXPECT_EQ(lineAt(40, 30), 0U) << "uncut";
}

TEST_F(CliSimulate, RecordsReportWhatEachBlockCutAndItsTotals) {
    const auto done = simulate("--records r.csv --json");
    ASSERT_EQ(done.exitCode, 0) << done.err;
    EXPECT_THAT(
        read("r.csv"),
        testing::StartsWith("block,line,facesShown,facesFull,regionsDirty,regionsDecimated,cutSeconds,"
                            "decimationSeconds,removedMm3,maxDepthMm,radialEngagementMm,cuts,firstContact,"
                            "rateMm3PerMin,feedLengthMm\n"));
    const auto rows = records("r.csv");
    ASSERT_EQ(rows.size(), 6U);
    ASSERT_EQ(rows.front().size(), 2 + blockStatistics().size());
    for (std::size_t k = 0; k < blockStatistics().size(); ++k)
        EXPECT_EQ(rows.front()[2 + k], blockStatistics()[k].column);
    const auto column = [&rows](const std::string& name) {
        return static_cast<std::size_t>(std::ranges::find(rows.front(), name) - rows.front().begin());
    };
    ASSERT_LT(column("rateMm3PerMin"), rows.front().size());
    const auto value = [&](std::size_t row, const std::string& name) {
        return std::stod(rows[row].at(column(name)));
    };
    // To X5 Y5 Z5, down to Z-2, along to X30, an arc, up.
    EXPECT_EQ(value(1, "cuts"), 0);
    EXPECT_EQ(value(2, "firstContact"), 1);
    EXPECT_EQ(value(3, "firstContact"), 0);
    EXPECT_EQ(value(3, "cuts"), 1);
    EXPECT_EQ(value(3, "feedLengthMm"), 25);
    EXPECT_NEAR(value(3, "radialEngagementMm"), 3,
                0.01); // except for the rim of 4 mm, where nothing is removed
    EXPECT_NEAR(value(3, "rateMm3PerMin"), value(3, "removedMm3") / 25 * 100, 1e-6);
    EXPECT_EQ(rows[5].at(column("rateMm3PerMin")), ""); // a rapid
    double removed = 0;
    for (std::size_t row = 1; row < rows.size(); ++row)
        removed += value(row, "removedMm3");
    const auto json = done.json();
    EXPECT_NEAR(json["removedMm3"].get<double>(), removed, 1e-6);
    const auto totals = json["records"];
    EXPECT_EQ(totals["airLengthMm"], 0);
    EXPECT_EQ(totals["contacts"], 1);
    EXPECT_EQ(totals["axialDepth"]["mm"], 2);
    EXPECT_EQ(totals["firstContact"]["line"], 4);
    EXPECT_NEAR(totals["firstContact"]["z"].get<double>(), 0, 0.002);
    const auto begun = simulate("--json --until 1").json();
    EXPECT_TRUE(begun["records"]["firstContact"].is_null());
    EXPECT_EQ(begun["movingBlocks"], 1);
    EXPECT_GT(begun["movingBlocksInProgram"], 1);
    EXPECT_EQ(begun["finished"], false);
}

/// More blocks than are read before the first of them are cut; a rapid in the stock and an unknown code
/// follow.
std::string longProgram(const std::string& end) {
    std::string text = "G21 G90\nT1 M6\nG0 X5 Y5 Z5\nF1000\n";
    for (int block = 0; block < 130'000; ++block)
        text +=
            fmt::format("G1 X{} Y{:.3f} Z{:.4f}\n", block % 2 == 0 ? 2 : 38, 0.0002 * block, -block * 5e-6);
    return text + end + "G0 Z5\nM30\n";
}

TEST_F(CliSimulate, CuttingAProgramWhileItIsReadHasTheSameResult) {
    for (const std::string end : {"G0 X20 Y20 Z-3\nG91.7\n", "T2 M6\nG1 X5 Z-4\n"}) {
        write("long.nc", longProgram(end));
        std::vector<nlohmann::json> results;
        for (const std::string threads : {"1", "2"}) {
            const auto done = run("simulate long.nc --json --zmap z" + threads + ".npy --threads " + threads +
                                  kStock + kTool + "--tool 2=flat:d=6");
            results.push_back(done.json());
            ASSERT_TRUE(results.back().is_object()) << done.err;
            EXPECT_GT(results.back()["secondsBeside"]["interpret"], 0);
            for (const char* cost : {"seconds", "secondsBeside", "threads", "cpuSeconds", "expectedBytes",
                                     "forecastBytes", "peakBytes"})
                results.back().erase(cost);
        }
        EXPECT_EQ(results[0], results[1]);
        EXPECT_EQ(read("z1.npy"), read("z2.npy"));
        EXPECT_EQ(results[0]["movingBlocks"], results[0]["movingBlocksInProgram"]);
        EXPECT_GT(results[0]["movingBlocks"], 130'000);
    }
}

TEST_F(CliSimulate, MessagesOfAProgramThatIsReadPrecedeThoseOfItsSetup) {
    write("long.nc", longProgram("G91.7\n"));
    for (const std::string threads : {"1", "2"}) { // the STL file would be too coarse
        const auto done =
            run("simulate long.nc --json --stl far.stl --stock 40x30x10 --stock-origin 1000000,0,0 "
                "--grid 0.5 --threads " +
                threads + kTool);
        EXPECT_EQ(done.exitCode, 3);
        EXPECT_TRUE(done.reports("long.nc:130005:", "code-unknown")) << done.err;
        EXPECT_TRUE(done.reports("far.stl:", "export-rounding-too-large")) << done.err;
        EXPECT_LT(done.err.find("code-unknown"), done.err.find("export-rounding-too-large")) << done.err;
        EXPECT_EQ(done.json()["findings"].size(), 1U) << done.out;
        EXPECT_EQ(done.json()["unverified"].size(), 1U) << done.out;
    }
}

TEST_F(CliSimulate, PutsWallsOfFilesWhereTheyStand) {
    write("p.nc", "T1 M6\nS1000 M3\nG0 X10 Y8 Z5\nG1 Z-3 F300\nX30 Y14\nG0 Z5\nM30\n"); // a slot aslant
    const auto cut = [&](const std::string& more) {
        return run("simulate p.nc --json --tool 1=flat:d=4,l=20" + kStock + more);
    };
    const double length = std::hypot(20, 6);
    const double exact = 3 * (length * 4 + std::numbers::pi * 4);
    const auto beside = [&](const std::string& more) {
        return std::abs(cut(more).json()["removedMm3"].get<double>() - exact) / exact;
    };
    EXPECT_LT(beside(""), 5e-4); // at 0.5 mm
    EXPECT_GT(beside("--rims off"), 2e-3);
    const auto off = cut("--rims off --zmap off.npy --stl off.stl");
    EXPECT_EQ(off.exitCode, 0) << off.err;
    EXPECT_FALSE(off.json().contains("rims"));
    const auto on = cut("--zmap on.npy --stl on.stl");
    EXPECT_EQ(on.exitCode, 0) << on.err;
    EXPECT_GT(on.json()["rims"], 0) << on.out; // of the slot's sides
    EXPECT_LT(on.json()["stl"]["triangles"], off.json()["stl"]["triangles"]);
    EXPECT_EQ(read("on.npy"), read("off.npy"));
    EXPECT_EQ(cut("--until 1 --stl one.stl").json()["rims"], 0);
    EXPECT_FALSE(cut("--method lee --stl lee.stl").json().contains("rims"));
    EXPECT_EQ(cut("--rims maybe").exitCode, 3);
}

TEST_F(CliSimulate, JsonHasTheKeysOfTheContract) {
    const auto done = simulate("--json");
    ASSERT_EQ(done.exitCode, 0) << done.err;
    const auto json = done.json();
    for (const char* key : {"blocks", "motions", "grid", "removedMm3", "facesFull", "facesDecimated",
                            "largestErrorMm", "errorLevel", "seconds", "peakBytes", "findings", "unverified"})
        EXPECT_TRUE(json.contains(key)) << key;
    double sum = 0;
    for (const char* phase :
         {"prepare", "interpret", "allocate", "cut", "rims", "decimate", "evaluate", "write", "box"}) {
        EXPECT_GE(json["seconds"].value(phase, -1.0), 0) << phase;
        sum += json["seconds"].value(phase, 0.0);
    }
    const double total = json["seconds"].value("total", 0.0);
    EXPECT_NEAR(sum, total, 0.03 * total); // the phases are the whole run
    EXPECT_GT(json["cpuSeconds"], 0);
    EXPECT_EQ(simulate("--json --threads 1").json()["threads"], 1);
    EXPECT_EQ(json["blocks"], 8);
    EXPECT_EQ(json["motions"], 5);
    EXPECT_EQ(json["grid"]["nx"], 81);
    EXPECT_EQ(json["grid"]["ny"], 61);
    EXPECT_EQ(json["grid"]["hx"], 0.5);
    EXPECT_EQ(json["grid"]["hy"], 0.5);
    EXPECT_EQ(json["facesFull"], 2 * 80 * 60);
    EXPECT_LT(json["facesDecimated"], json["facesFull"]);
    EXPECT_EQ(json["errorLevel"], "surface");
    EXPECT_GT(json["largestErrorMm"], 0);
    EXPECT_LE(json["largestErrorMm"], 0.05);
    EXPECT_GT(json["peakBytes"], 1000);
    EXPECT_TRUE(json["findings"].empty());
    EXPECT_TRUE(json["unverified"].empty());
}

TEST_F(CliSimulate, AProgramWhoseHeightIsNeverKnownIsUnverified) {
    write("flat.nc", "T1 M6\nG0 X0 Y0\nG0 X40\nM2\n");
    const auto done = run("simulate flat.nc --json" + kStock + kTool);
    EXPECT_EQ(done.exitCode, 2);
    EXPECT_TRUE(done.reports("flat.nc:3:", "rapid-unchecked")) << done.err;
    EXPECT_TRUE(done.reports("flat.nc:4:", "position-never-known")) << done.err;
}

TEST_F(CliSimulate, RemovedVolumeIsThatOfTheCut) {
    // A horizontal slot by a 4 mm ball, 2 mm deep: half a disc times its length, and a quarter ball at each
    // end.
    write("slot.nc", "T1 M6\nG0 X10 Y15 Z5\nG1 Z-2 F100\nX30\nG0 Z5\n");
    const auto done = run("simulate slot.nc --stock 40x30x10 --grid 0.1 --json" + kTool);
    const double half = M_PI * 2 * 2 / 2;
    const double exact = 20 * half + 2.0 / 3.0 * M_PI * 8;
    EXPECT_NEAR(done.json()["removedMm3"].get<double>(), exact, 0.01 * exact);
}

TEST_F(CliSimulate, UntilStopsAfterABlockOrALine) {
    const std::map<std::string, int> motions{{"0", 0},   {"1", 1},  {"3", 3},   {"5", 5},
                                             {"999", 5}, {"L1", 0}, {"L2", 0},  {"L3", 1},
                                             {"L5", 3},  {"L8", 5}, {"L999", 5}};
    for (const auto& [until, count] : motions)
        EXPECT_EQ(simulate("--json --until " + until).json()["motions"], count) << until;
}

TEST_F(CliSimulate, UntilALineIncludesTheSubprogramThatItCalls) {
    write("sub.ngc", "o<sub> sub\nG1 X20 F300\nX25\no<sub> endsub\nM2\n");
    write("call.ngc",
          "T1 M6\nG0 X5 Y5 Z5\no<sub> call\no1 call\nS100\nG1 X10\nM2\no1 sub\nG1 X15\no1 endsub\n");
    for (const auto& [until, count] :
         std::map<std::string, int>{{"L2", 1}, {"L3", 3}, {"L4", 4}, {"L5", 4}, {"L6", 5}, {"L9", 4}})
        EXPECT_EQ(run("simulate call.ngc --json --until " + until + kStock + kTool).json()["motions"], count)
            << until;
}

TEST_F(CliSimulate, ZMapHasAbsoluteHeightsRowZeroAtTheLeastY) {
    ASSERT_EQ(run("simulate p.nc --zmap a.npy --stock-origin 0,0,1" + kStock + kTool).exitCode, 0);
    const auto heights = readNpy(folder / "a.npy");
    ASSERT_TRUE(heights);
    EXPECT_EQ(heights->rows, 61);
    EXPECT_EQ(heights->columns, 81);
    const auto at = [&](double x, double y) {
        return heights->values[static_cast<std::size_t>(std::lround(y / 0.5) * 81 + std::lround(x / 0.5))];
    };
    EXPECT_NEAR(at(15, 5), -2, 1e-5); // the slot is along y = 5
    EXPECT_NEAR(at(15, 25), 1, 1e-5);
    EXPECT_NEAR(at(25, 0), -2, 1e-5); // the clockwise arc extends below the slot
}

TEST_F(CliSimulate, SolidIsClosedAndDecimatedWhateverThePeriod) {
    ASSERT_EQ(simulate("--stl full.stl --mesh full").exitCode, 0);
    ASSERT_EQ(simulate("--stl never.stl --period 0").exitCode, 0);
    ASSERT_EQ(simulate("--stl every.stl --period 1").exitCode, 0);
    ASSERT_EQ(simulate("--stl text.stl --ascii").exitCode, 0);
    EXPECT_EQ(read("never.stl"), read("every.stl"));
    EXPECT_TRUE(read("text.stl").starts_with("solid"));
    const auto triangles = [this](const std::string& name) {
        const auto mesh = readStl(folder / name);
        EXPECT_TRUE(mesh) << name;
        // Closed: each directed edge has exactly one opposite edge.
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        for (const auto& t : mesh->triangles)
            for (std::size_t k = 0; k < 3; ++k) {
                ++edges[{t[k], t[(k + 1) % 3]}];
                --edges[{t[(k + 1) % 3], t[k]}];
            }
        EXPECT_TRUE(std::ranges::all_of(edges, [](const auto& edge) { return edge.second == 0; })) << name;
        return mesh->triangles.size();
    };
    EXPECT_LT(triangles("never.stl"), triangles("full.stl") / 2);
    EXPECT_EQ(triangles("text.stl"), triangles("never.stl"));
}

TEST_F(CliSimulate, FullMeshIsNeverDecimated) {
    const auto json = simulate("--mesh full --json").json();
    EXPECT_EQ(json["facesDecimated"], json["facesFull"]);
    EXPECT_EQ(json["errorLevel"], "none");
    EXPECT_EQ(json["largestErrorMm"], 0);
    EXPECT_EQ(simulate("--method none --json").json()["errorLevel"], "none");
    EXPECT_EQ(simulate("--allowance 0 --json").json()["facesDecimated"], json["facesFull"]);
    EXPECT_EQ(simulate("--level sample --json").json()["errorLevel"], "sample");
    EXPECT_EQ(simulate("--method lee --json").json()["errorLevel"], "sample");
    EXPECT_EQ(simulate("--method lee --no-certify --json").json()["errorLevel"], "measured");
}

TEST_F(CliSimulate, AnStlFarFromTheOriginIsRefusedOrItsRoundingCounted) {
    const std::string grid = " --stock 10x10x10 --grid 0.05 --mesh full --json --stl a.stl" + kTool;
    const auto refused = run("simulate p.nc --stock-origin 1e6,0,0" + grid);
    EXPECT_EQ(refused.exitCode, 3);
    EXPECT_TRUE(refused.reports("a.stl: error: ", "stl-too-coarse")) << refused.err;
    EXPECT_FALSE(exists("a.stl"));
    write("above.nc", "T1 M6\nG0 X5 Y5 Z100050\n");
    const auto far = run("simulate above.nc --stock-origin 0,0,100000.002" + grid);
    // The step of float32 is 1/128 mm there.
    EXPECT_NEAR(far.json()["largestErrorMm"], std::abs(100000.002 - 100000.0), 1e-6);
    EXPECT_EQ(run("simulate p.nc" + grid).json()["largestErrorMm"], 0);
}

TEST_F(CliSimulate, BordersOfThePaperAreMeasuredAndNotExported) {
    EXPECT_EQ(simulate("--borders paper --json").exitCode, 0);
    const auto refused = simulate("--borders paper --stl a.stl");
    EXPECT_EQ(refused.exitCode, 3);
    EXPECT_THAT(refused.err, HasSubstr("[borders-not-exported]"));
    EXPECT_FALSE(exists("a.stl"));
}

TEST_F(CliSimulate, RecordsHaveARowABlock) {
    ASSERT_EQ(simulate("--records a.csv --period 2").exitCode, 0);
    const auto rows = records("a.csv");
    ASSERT_EQ(rows.size(), 6U);
    EXPECT_EQ(rows[0][0], "block");
    EXPECT_EQ(rows[0][2], "facesShown");
    const auto column = [&](const std::string& name) {
        return static_cast<std::size_t>(std::distance(rows[0].begin(), std::ranges::find(rows[0], name)));
    };
    double removed = 0;
    for (std::size_t row = 1; row < rows.size(); ++row) {
        ASSERT_EQ(rows[row].size(), rows[0].size());
        EXPECT_EQ(rows[row][0], std::to_string(row));
        EXPECT_EQ(rows[row][column("line")], std::to_string(row + 2));
        EXPECT_EQ(rows[row][column("facesFull")], "9600");
        removed += std::stod(rows[row][column("removedMm3")]);
    }
    EXPECT_NEAR(removed, simulate("--json").json()["removedMm3"].get<double>(), 1e-2);
    EXPECT_GT(std::stoi(rows[3][column("regionsDirty")]), 0);
    EXPECT_EQ(rows[4][column("regionsDirty")], "0"); // every second block decimates
    EXPECT_GT(std::stoi(rows[4][column("regionsDecimated")]), 0);
}

TEST_F(CliSimulate, GlobalDecimationFollowsEveryBlockUnlessAPeriodIsGiven) {
    const auto dirty = [this](const std::string& more) {
        EXPECT_EQ(simulate("--records a.csv --method global " + more).exitCode, 0);
        std::string out;
        const auto rows = records("a.csv");
        EXPECT_EQ(rows.at(0).at(4), "regionsDirty");
        for (std::size_t row = 1; row < rows.size(); ++row)
            out += rows[row][4];
        return out;
    };
    EXPECT_EQ(dirty(""), "00000");
    EXPECT_EQ(dirty("--period 2"), "00100") << "blocks 2, 3 and 4 cut";
    EXPECT_EQ(dirty("--period 20"), "01111");
    EXPECT_THAT(run("simulate --help").out, HasSubstr("global: 1"));
}

TEST_F(CliSimulate, ResultsDoNotDependOnThreads) {
    ASSERT_EQ(simulate("--threads 1 --zmap a.npy --stl a.stl").exitCode, 0);
    ASSERT_EQ(simulate("--threads 8 --zmap b.npy --stl b.stl").exitCode, 0);
    EXPECT_TRUE(read("a.npy") == read("b.npy"));
    EXPECT_TRUE(read("a.stl") == read("b.stl"));
}

TEST_F(CliSimulate, JobFileHoldsTheSameAsOptionsAndOptionsOutrankIt) {
    write("p.proveout", R"({"proveout": 1, "program": "p.nc",
        "stock": {"corner": [0, 0, 0], "width": 40, "depth": 30, "height": 10}, "grid": 0.5,
        "tools": {"1": "ball:d=4,l=20"}, "decimation": {"region": 16, "allowance": 0.05}})");
    ASSERT_EQ(run("simulate --job p.proveout --zmap a.npy --stl a.stl").exitCode, 0);
    ASSERT_EQ(simulate("--zmap b.npy --stl b.stl").exitCode, 0);
    EXPECT_TRUE(read("a.npy") == read("b.npy"));
    EXPECT_TRUE(read("a.stl") == read("b.stl"));
    EXPECT_EQ(run("simulate --job p.proveout --grid 1 --json").json()["grid"]["nx"], 41);
    write("other.nc", "T1 M6\nG0 X5 Y5 Z5\n");
    EXPECT_EQ(run("simulate other.nc --job p.proveout --json").json()["motions"], 1);
    const auto coarse = run("simulate --job p.proveout --region 30 --allowance 0.5 --json").json();
    EXPECT_LT(coarse["facesDecimated"], run("simulate --job p.proveout --json").json()["facesDecimated"]);
}

TEST_F(CliSimulate, FieldsOfAJobThatAreNotKnownAreWarnings) {
    write("p.proveout", R"({"proveout": 1, "program": "p.nc",
        "stock": {"width": 40, "depth": 30, "height": 10}, "gird": 0.5,
        "tools": {"1": "ball:d=4,l=20"}})");
    const auto done = run("simulate --job p.proveout --json");
    EXPECT_EQ(done.exitCode, 0);
    EXPECT_TRUE(done.reports("p.proveout:2:60: warning: The field \"gird\"", "job-field-unknown"))
        << done.err;
    const auto json = done.json();
    ASSERT_EQ(json["findings"].size(), 1U);
    EXPECT_EQ(json["findings"][0]["severity"], "warning");
    EXPECT_EQ(json["findings"][0]["file"], "p.proveout");
    EXPECT_EQ(json["findings"][0]["line"], 2);
}

TEST_F(CliSimulate, TheMethodOfTheJobGivenAgainKeepsItsRegion) {
    write("p.proveout", R"({"proveout": 1, "program": "p.nc",
        "stock": {"width": 40, "depth": 30, "height": 10}, "grid": 0.5,
        "tools": {"1": "ball:d=4,l=20"}, "decimation": {"method": "lee", "region": 20}})");
    EXPECT_EQ(run("simulate --job p.proveout --json").json()["regions"], 4 * 3);
    EXPECT_EQ(run("simulate --job p.proveout --method lee --json").json()["regions"], 4 * 3);
}

TEST_F(CliSimulate, ToolTableAndToolOptionMeanTheSame) {
    write("t.toml", "[[tool]]\nnumber = 1 # roughing\ncutter = \"ball:d=4,l=20\"\n");
    const auto one = run("simulate p.nc --json --tools t.toml" + kStock).json();
    EXPECT_EQ(one["removedMm3"], simulate("--json").json()["removedMm3"]);
    EXPECT_EQ(one["removedMm3"],
              run("simulate p.nc --json --tool T1=ball:d=4,l=20" + kStock).json()["removedMm3"]);
    const auto two = run("simulate p.nc --json --tools t.toml --tool 1=ball:d=6,l=20" + kStock).json();
    EXPECT_GT(two["removedMm3"], one["removedMm3"]); // the option takes precedence over the table
}

TEST_F(CliSimulate, BlockDeleteAndStart) {
    write("d.nc", "T1 M6\nG0 X5 Y5 Z5\n/G0 X9\nX7\n");
    EXPECT_EQ(run("simulate d.nc --json" + kStock + kTool).json()["motions"], 3);
    EXPECT_EQ(run("simulate d.nc --json --block-delete" + kStock + kTool).json()["motions"], 2);
    write("s.nc", "T1 M6\nG1 Z-2 F100\n");
    EXPECT_EQ(run("simulate s.nc --json" + kStock + kTool).exitCode, 2);
    const auto started = run("simulate s.nc --json --start 20,15,5" + kStock + kTool);
    EXPECT_EQ(started.exitCode, 0) << started.err;
    EXPECT_GT(started.json()["removedMm3"], 1);
}

TEST_F(CliSimulate, TheStartOfCompensationIsInTheJobOrOutranksIt) {
    write("c.nc", "G90 G0 X5. Y15. Z-1.\nG1 G42 D1 X20. Y15. F100\nX10. Y25.\nG40 X20.\nM30\n");
    write("c.proveout", R"({"proveout": 1, "program": "c.nc", "dialect": "fanuc", "compensationStart": "b",
        "stock": {"width": 40, "depth": 30, "height": 10}, "tools": {"1": "ball:d=4,l=20"}})");
    const auto motions = [this](const std::string& more) {
        return run("simulate --job c.proveout --json" + more).json()["motions"].get<int>();
    };
    EXPECT_EQ(motions(""), 5);
    EXPECT_EQ(motions(" --compensation-start b"), 5);
    EXPECT_EQ(motions(" --compensation-start a"), 4);
    EXPECT_TRUE(run("simulate --job c.proveout --dialect linuxcnc")
                    .reports("c.proveout: warning: Cutter compensation start-up type B ",
                             "compensation-start-unused"));
}

TEST_F(CliSimulate, NothingLeftIsSaid) {
    write("all.nc", "T1 M6\nG0 X-40 Y15 Z5\nG1 Z-10 F100\nX90\n");
    const auto done = run("simulate all.nc --stock 40x30x10 --grid 1 --tool 1=flat:d=90,l=20 --stl a.stl");
    EXPECT_EQ(done.exitCode, 3);
    EXPECT_THAT(done.err, HasSubstr("[nothing-left]"));
    EXPECT_FALSE(exists("a.stl"));
}

TEST_F(CliSimulate, SampleOfTheRepositoryRunsClean) {
    const std::string job = std::string(PROVEOUT_SOURCE_DIR) + "/resources/samples/mouse-case.proveout";
    const auto done = run("simulate --job " + job + " --json --records r.csv");
    ASSERT_EQ(done.exitCode, 0) << done.err;
    EXPECT_EQ(done.json()["movingBlocks"], 10'273);
    EXPECT_EQ(done.json()["movingBlocksInProgram"], 10'273);
    EXPECT_EQ(done.json()["finished"], true);
    EXPECT_EQ(records("r.csv").size(), 10'274U);
    EXPECT_LE(done.json()["largestErrorMm"], 0.05);
}

} // namespace
} // namespace proveout
