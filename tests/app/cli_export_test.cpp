// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh files of the two commands that write them.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <map>

#include "core/formats/formats.h"
#include "tests/app/command_line.h"
#include "tests/core/formats/steep_maps.h"

namespace proveout {
namespace {

using testing::HasSubstr;

class CliExport : public CommandLine {
protected:
    void SetUp() override { write("p.nc", kSound); }
    Finished simulate(const std::string& more) { return run("simulate p.nc" + kStock + kTool + more); }

    /// A slot in a stock far from the origin, where the step of float32 is 1/32 mm.
    Finished simulateFarOut(const std::string& more) {
        write("far.nc", "T1 M6\nG0 X2000005 Y5 Z5\nG1 Z-2 F100\nX2000030\nG0 Z5\nM30\n");
        return run("simulate far.nc --stock 40x30x10 --grid 0.5 --stock-origin 2000000.05,0,0" + kTool +
                   more);
    }
};

TEST_F(CliExport, EveryMeshFormatIsWrittenByItsEnding) {
    std::string options = " --json";
    std::vector<std::string> files;
    for (const FileFormat& format : fileFormats())
        if (format.meshWriter() != nullptr && std::string(format.key) != "stl-ascii")
            files.push_back(std::string("a") + format.extensions.front());
    for (const std::string& file : files)
        options += " --export " + file;
    const auto done = simulate(options);
    ASSERT_EQ(done.exitCode, 0) << done.err;
    const auto rows = done.json()["exports"];
    ASSERT_EQ(rows.size(), files.size());
    for (std::size_t i = 0; i < files.size(); ++i) {
        EXPECT_EQ(rows[i]["file"], files[i]);
        EXPECT_EQ(rows[i]["format"], meshFormatOf(files[i]).value()->key);
        EXPECT_EQ(rows[i]["triangles"], rows[0]["triangles"]);
        EXPECT_EQ(rows[i]["bytes"], std::filesystem::file_size(folder / files[i]));
        const bool rounds = files[i] == "a.stl" || files[i] == "a.glb";
        EXPECT_EQ(rows[i]["coordinates"], rounds ? "float32" : "float64");
        EXPECT_NEAR(rows[i]["largestErrorMm"], done.json()["largestErrorMm"], 1e-4);
    }
    EXPECT_FALSE(done.json().contains("stl")) << "that option was not given";
}

TEST_F(CliExport, StlIsStlWhateverItsEnding) {
    const auto done = simulate("--json --stl a.mesh --export b.STL");
    ASSERT_EQ(done.exitCode, 0) << done.err;
    EXPECT_EQ(read("a.mesh"), read("b.STL"));
    const auto stl = done.json()["stl"];
    EXPECT_EQ(stl["triangles"], readStl(folder / "a.mesh")->triangles.size());
    EXPECT_EQ(stl["bytes"], std::filesystem::file_size(folder / "a.mesh"));
    EXPECT_GT(stl["largestErrorMm"], 0);
    EXPECT_EQ(done.json()["exports"].size(), 2U);
}

TEST_F(CliExport, AsciiIsAboutStlAlone) {
    ASSERT_EQ(simulate("--ascii --export a.stl --stl b.stl --export c.ply").exitCode, 0);
    ASSERT_EQ(simulate("--export d.ply").exitCode, 0);
    EXPECT_TRUE(read("a.stl").starts_with("solid"));
    EXPECT_EQ(read("a.stl"), read("b.stl"));
    EXPECT_EQ(read("c.ply"), read("d.ply"));
}

TEST_F(CliExport, UnknownEndingsAreRefusedBeforeTheWork) {
    write("a.npy", "no array");
    for (const std::string& command :
         {"simulate p.nc --json" + kStock + kTool, std::string("decimate a.npy --grid 1 --json")}) {
        for (const std::string& file :
             {std::string("a.step"), std::string("a"), std::string("folder/a.stl.gz")}) {
            const auto done = run(command + " --export " + file);
            EXPECT_EQ(done.exitCode, 3);
            EXPECT_TRUE(done.reports(file +
                                         ": error: The extension of this name is not that of a mesh format; "
                                         "there are " +
                                         meshEndings() + ".",
                                     "export-format-unknown"))
                << done.err;
            EXPECT_EQ(done.json()["findings"][0]["id"], "export-format-unknown");
            EXPECT_FALSE(done.json().contains("removedMm3"));
        }
    }
}

/// The size of a decimated mesh is known only after writing it.
TEST_F(CliExport, AFileThatOutgrowsTheDiskKeepsNoOtherBack) {
    ASSERT_EQ(simulate("--export a.obj --export b.3mf").exitCode, 0);
    const std::size_t larger = read("a.obj").size();
    const std::size_t smaller = read("b.3mf").size();
    constexpr std::size_t kUnit = 512; // block size of ulimit
    ASSERT_GT(larger, smaller + 2 * kUnit);
    std::filesystem::remove(folder / "a.obj");
    std::filesystem::remove(folder / "b.3mf");
    const auto done = run("simulate p.nc --json --export a.obj --export b.3mf" + kStock + kTool,
                          "ulimit -f " + std::to_string(smaller / kUnit + 1) + ";");
    EXPECT_EQ(done.exitCode, 3);
    EXPECT_TRUE(done.reports("a.obj: error: The file cannot be written (", "file-unwritable")) << done.err;
    EXPECT_FALSE(exists("a.obj"));
    EXPECT_TRUE(exists("b.3mf"));
    const auto rows = done.json()["exports"];
    EXPECT_TRUE(std::ranges::any_of(rows, [](const auto& row) { return row["file"] == "b.3mf"; }));
}

TEST_F(CliExport, OutputsMustDiffer) {
    EXPECT_TRUE(simulate("--export a.stl --stl a.stl").reports("a.stl: error: ", "output-overwrites"));
    EXPECT_TRUE(simulate("--export a.obj --export ./a.obj").reports("./a.obj: error: ", "output-overwrites"));
    EXPECT_TRUE(simulate("--method lee --borders paper --export a.3mf")
                    .reports("p.nc: error: ", "borders-not-exported"));
}

TEST_F(CliExport, RoundingBeyondHalfOfTheAllowanceIsRefusedBeforeTheRun) {
    const auto done = simulateFarOut("--json --export a.stl --export a.obj");
    EXPECT_EQ(done.exitCode, 3);
    EXPECT_TRUE(done.reports("a.stl: error: Single precision rounds positions in this stock by up to 0.06",
                             "export-rounding-too-large"))
        << done.err;
    EXPECT_EQ(done.json()["findings"][0]["id"], "export-rounding-too-large");
    EXPECT_THAT(done.json()["findings"][0]["hint"].get<std::string>(), HasSubstr(".obj .ply .3mf"));
    EXPECT_FALSE(done.json().contains("removedMm3"));
    EXPECT_FALSE(exists("a.stl"));
    const auto exact = simulateFarOut("--json --export a.obj");
    EXPECT_EQ(exact.exitCode, 0);
    EXPECT_LE(exact.json()["largestErrorMm"], 0.05);
    EXPECT_EQ(exact.err, "");
    ASSERT_EQ(simulateFarOut("--zmap a.npy").exitCode, 0);
    const auto decimated = run("decimate a.npy --grid 0.5 --origin 2000000.05,0 --stl b.stl --json");
    EXPECT_EQ(decimated.exitCode, 3);
    EXPECT_TRUE(decimated.reports("b.stl: error: Single precision", "export-rounding-too-large"));
    EXPECT_FALSE(exists("b.stl"));
}

/// Every point of the grid is kept, so nothing could be made for less.
TEST_F(CliExport, TheRoundingOfAFullMeshIsAWarning) {
    const auto done = simulateFarOut("--json --mesh full --export a.stl --export a.obj");
    ASSERT_EQ(done.exitCode, 0) << done.err;
    EXPECT_TRUE(done.reports("a.stl: warning: Rounded to single precision", "export-rounded-beyond"))
        << done.err;
    EXPECT_FALSE(done.reports("a.obj: warning: ", "export-rounded-beyond"));
    const auto rows = done.json()["exports"];
    EXPECT_GT(rows[0]["largestErrorMm"], 0.05);
    EXPECT_EQ(rows[1]["largestErrorMm"], 0);
    EXPECT_EQ(done.json()["largestErrorMm"], rows[0]["largestErrorMm"]) << "of all that was put out";
}

/// Half a step of float32 is 1.2e-4 mm there, and the walls of the slots are steep.
TEST_F(CliExport, ASteepPartFarFromTheOriginKeepsTheAllowance) {
    write("steep.nc", "T1 M6\nG0 X3005 Y5 Z5\nG1 Z-6 F100\nX3025 Y12 Z-3\nX3012 Y20 Z-5\nG0 Z5\nM30\n");
    const std::string simulate = "simulate steep.nc --stock 30x25x10 --grid 0.1 "
                                 "--stock-origin 3000.05,0,0 --tool 1=ball:d=6,l=30 --rims off --json ";
    const auto done = run(simulate + "--export a.stl --export a.ply --zmap a.npy");
    ASSERT_EQ(done.exitCode, 0) << done.err;
    EXPECT_EQ(done.err, "");
    const auto json = done.json();
    EXPECT_LE(json["exports"][0]["largestErrorMm"], 0.05);
    EXPECT_GT(json["exports"][0]["largestErrorMm"], 0.045);
    EXPECT_EQ(json["exports"][0]["triangles"], json["exports"][1]["triangles"]) << "one mesh for all files";
    EXPECT_LE(json["largestErrorMm"], 0.05);
    const auto npy = readNpy(folder / "a.npy");
    const ZMapSnapshot zmap = test::mapAt({3000.05, 0, 0}, 30, 25, 0.1, [&](int i, int j) {
        return static_cast<double>(
            npy->values[static_cast<std::size_t>(j) * npy->columns + static_cast<std::size_t>(i)]);
    });
    EXPECT_LE(test::distanceFrom(zmap, *readStl(folder / "a.stl")), 0.05 + 1e-9);
    // The allowance less the rounding of the coordinates alone, which does not suffice for steep walls.
    const double once = 0.05 - std::ldexp(1, -13) - std::ldexp(1, -20) - std::ldexp(1, -21);
    const auto first = run(simulate + fmt::format("--allowance {:.12f} --export b.ply", once));
    EXPECT_LT(first.json()["facesDecimated"], json["facesDecimated"]) << "made only once";

    const auto decimated =
        run("decimate a.npy --grid 0.1 --origin 3000.05,0 --floor -10 --export c.stl --json");
    ASSERT_EQ(decimated.exitCode, 0) << decimated.err;
    EXPECT_LE(decimated.json()["exports"][0]["largestErrorMm"], 0.05);
    EXPECT_LE(test::distanceFrom(zmap, *readStl(folder / "c.stl")), 0.05 + 1e-9);
}

/// Single precision may round the outline of the stock outwards.
TEST_F(CliExport, WallsAcrossTheBorderStandWhereTheyAreAtAnyOrigin) {
    for (const char* origin : {"0", "0.7", "1.4", "-0.1", "25.4"}) {
        const double x = std::stod(origin);
        write("p.nc", fmt::format("T1 M6\nG0 X{} Y5.03 Z5\nG1 Z-2 F100\nX{}\nG0 Z5\nM30\n", x - 5, x + 15));
        const auto done = run(fmt::format("simulate p.nc --json --stock 10x10x5 --grid 0.1 --allow-outside "
                                          "--stock-origin {},0,0 --tool 1=flat:d=3.3,l=30 --stl s.stl",
                                          origin));
        ASSERT_LT(done.exitCode, 3) << done.err;
        EXPECT_FALSE(done.reports("s.stl: note: ", "export-walls-on-grid")) << origin << done.err;
        EXPECT_LT(done.json()["stl"]["triangles"], 100) << origin;
    }
}

/// One triangle that is too far from a point need not be near the walls that it belongs to.
TEST_F(CliExport, OneTriangleDoesNotTakeAllWallsWithIt) {
    write("p.nc",
          "T1 M6\nS1000 M3\nG0 Z5\nX5 Y5\nG1 Z-3 F500\nX25 Y9\nG3 X20 Y20 I-5 J5\nG1 X3 Y22 Z-1\nZ-12\n"
          "X-5\nG0 Z5\nM30\n");
    const auto triangles = [&](const std::string& more) {
        return run("simulate p.nc --json --stock cylinder:d=30,h=10 --grid 0.06 --allow-outside --tool "
                   "1=bull:d=4,r=1,l=30 --stl s.stl" +
                   more)
            .json()["stl"]["triangles"]
            .get<int>();
    };
    EXPECT_LT(2 * triangles(""), triangles(" --rims off"));
}

TEST_F(CliExport, DecimateWritesTheSameFiles) {
    ASSERT_EQ(simulate("--zmap a.npy --export a.ply --region 64 --rims off").exitCode, 0);
    const auto done = run("decimate a.npy --grid 0.5 --allowance 0.05 --region 64 --floor -10 --export b.ply "
                          "--stl b.stl --json");
    ASSERT_EQ(done.exitCode, 0) << done.err;
    EXPECT_EQ(done.json()["exports"][0]["format"], "ply");
    EXPECT_EQ(done.json()["exports"][1]["format"], "stl");
    EXPECT_EQ(done.json()["stl"]["triangles"], done.json()["exports"][0]["triangles"]);
    EXPECT_TRUE(read("a.ply") == read("b.ply"));
}

TEST_F(CliExport, TheSummaryHasALineForEachFile) {
    const auto simulated = simulate("--zmap a.npy --export a.ply --export a.stl");
    const auto decimated = run("decimate a.npy --grid 0.5 --export b.ply --export b.stl");
    for (const std::string& line : {std::string(".ply: "), std::string(".stl: ")}) {
        EXPECT_THAT(simulated.out, testing::ContainsRegex(
                                       "\na\\" + line + "[0-9]+ triangles, .*largest vertical error 0\\.0"));
        EXPECT_THAT(decimated.out, testing::ContainsRegex(
                                       "\nb\\" + line + "[0-9]+ triangles, .*largest vertical error 0\\.0"));
    }
}

TEST_F(CliExport, FormatsListTheTypeOfCoordinates) {
    const auto rows = run("formats --json").json()["formats"];
    std::map<std::string, std::string> coordinates;
    for (const auto& row : rows)
        coordinates[row["key"]] = row.value("coordinates", "");
    EXPECT_EQ(coordinates["stl"], "float32");
    EXPECT_EQ(coordinates["stl-ascii"], "float32");
    EXPECT_EQ(coordinates["3mf"], "float64");
    EXPECT_EQ(coordinates["npy"], "");
    const auto text = run("formats").out;
    for (const char* part : {"obj", ".ply", ".3mf", "float64"})
        EXPECT_THAT(text, HasSubstr(part));
}

} // namespace
} // namespace proveout
