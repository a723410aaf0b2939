// SPDX-License-Identifier: GPL-3.0-or-later
// Stock of every shape, and passed from one setup to the next.
#include <cmath>
#include <map>
#include <numbers>

#include "core/formats/npy.h"
#include "core/formats/stl.h"
#include "core/formats/stock_shapes.h"
#include "tests/app/command_line.h"
#include "tests/core/decimation/closed_mesh.h"

namespace proveout {
namespace {

const std::string kAbove = "G21 G90\nT1 M6\nG0 X5 Y5 Z5\nX30\nM30\n"; ///< cuts nothing

class CliStock : public CommandLine {
protected:
    void SetUp() override {
        write("above.nc", kAbove);
        write("p.nc", kSound);
        write("plate.csv", "0,0\n40,0\n40,30\n0,30\n");
    }
    Finished simulate(const std::string& stock, const std::string& more = {},
                      const std::string& program = "p.nc") {
        return run("simulate " + program + " --stock " + stock + kTool + " --json " + more);
    }
};

TEST_F(CliStock, ShapesAreListedFromTheirTable) {
    const auto listed = run("stocks --json").json()["stocks"];
    ASSERT_EQ(listed.size(), stockShapes().size());
    for (std::size_t k = 0; k < listed.size(); ++k)
        EXPECT_EQ(listed[k]["key"], stockShapes()[k].key);
    EXPECT_NE(run("stocks").out.find("cylinder:d=50,h=20"), std::string::npos);
}

TEST_F(CliStock, ACylinderIsCutAndExported) {
    const auto done = simulate("cylinder:d=30,h=10", "--grid 0.1 --stl c.stl", "above.nc");
    ASSERT_EQ(done.exitCode, 0) << done.err;
    EXPECT_EQ(done.json()["grid"]["nx"], 301);
    EXPECT_EQ(done.json()["removedMm3"], 0);
    // The solid used as stock: the same heights again, without undercuts.
    const auto again = simulate("stl:file=c.stl", "--grid 0.1 --zmap z.npy", "above.nc");
    ASSERT_EQ(again.exitCode, 0) << again.err;
    const auto map = readNpy(folder / "z.npy").value();
    double volume = 0;
    for (const double z : map.values)
        volume += (z + 10) * 0.01;
    EXPECT_NEAR(volume, std::numbers::pi * 225 * 10, 0.005 * std::numbers::pi * 225 * 10);
}

/// Where nothing is left at the border of the map, its walls are where they stand too.
TEST_F(CliStock, WallsThatTouchTheBorderOfTheMapAreWhereTheyStand) {
    std::string rectangle;
    for (const auto& [x, y] : {std::pair{-15, -10}, {15, -10}, {15, 10}, {-15, 10}}) {
        const double turn = 17 * std::numbers::pi / 180;
        rectangle += fmt::format("{:.9f} {:.9f}\n", 30 + x * std::cos(turn) - y * std::sin(turn),
                                 30 + x * std::sin(turn) + y * std::cos(turn));
    }
    write("turned.csv", rectangle);
    struct Row {
        const char* stock;
        double exact;
        double share; // of the volume: chords of round walls keep the allowance
    };
    for (const auto& [stock, exact, share] :
         {Row{"outline:file=turned.csv,h=10", 30.0 * 20 * 10, 1e-5},
          Row{"cylinder:d=30,h=10", std::numbers::pi * 225 * 10, 1.5e-3}}) {
        for (const char* grid : {"1", "0.5", "0.1"}) {
            const auto done = simulate(stock, std::string("--stl s.stl --grid ") + grid, "above.nc");
            ASSERT_EQ(done.exitCode, 0) << done.err;
            EXPECT_EQ(done.err.find("export-walls-on-grid"), std::string::npos) << stock << grid;
            const TriangleMesh solid = readStl(folder / "s.stl").value();
            EXPECT_NEAR(test::signedVolume(solid), exact, share * exact) << stock << grid;
        }
    }
}

/// What is cut through is there on the other side, too.
TEST_F(CliStock, WallsOfAThroughCutAreWhereTheyStandWhenItIsFlipped) {
    write("through.nc", "T1 M6\nG0 X8 Y9.37 Z5\nG1 Z-11 F100\nX30 Y12\nG0 Z5\nM30\n");
    const std::string flat = " --tool 1=flat:d=6 --grid 0.7 ";
    ASSERT_NE(
        run("simulate through.nc --stock 40x30x10 --stl one.stl --save-stock one.pvstock" + flat).exitCode,
        1);
    const double exact = test::signedVolume(readStl(folder / "one.stl").value());
    for (const char* way : {"flip=x", "flip=y", "flip=x,turn=90"}) {
        const auto two = run(std::string("simulate above.nc --stock file:file=one.pvstock,") + way +
                             " --stl two.stl" + flat);
        EXPECT_EQ(two.exitCode, 0) << two.err;
        EXPECT_NEAR(test::signedVolume(readStl(folder / "two.stl").value()), exact, 1e-5 * exact) << way;
    }
}

/// What the map does not show is counted from setup to setup.
TEST_F(CliStock, RibsThatNoPointSeesAreCountedInTheNextSetup) {
    write("slots.nc",
          "T1 M6\nG0 X10 Y10.15 Z5\nG1 Z-2 F100\nX30\nG0 Z5\nX10 Y13.35\nG1 Z-2\nX30\nG0 Z5\nM30\n");
    const std::string flat = " --tool 1=flat:d=3 --json ";
    const auto one = run("simulate slots.nc --stock 40x30x10 --grid 0.5 --save-stock one.pvstock" + flat);
    ASSERT_EQ(one.exitCode, 0) << one.err;
    EXPECT_GT(one.json()["ribsUnseen"], 40);
    const auto two =
        run("simulate above.nc --stock file:file=one.pvstock --stl two.stl --save-stock two.pvstock" + flat);
    EXPECT_EQ(two.json()["ribsUnseen"], one.json()["ribsUnseen"]);
    EXPECT_NE(two.out.find("export-ribs-unseen"), std::string::npos);
    const auto three = run("simulate above.nc --stock file:file=two.pvstock,turn=90" + flat);
    EXPECT_EQ(three.json()["ribsUnseen"], one.json()["ribsUnseen"]);
    EXPECT_TRUE(three.json()["findings"].empty()) << three.out;
    const auto finer = run("simulate above.nc --stock file:file=one.pvstock --grid 0.25 --stl f.stl" + flat);
    EXPECT_EQ(finer.exitCode, 0) << finer.err;
    EXPECT_NE(finer.out.find("stock-walls-lost"), std::string::npos);
    EXPECT_NE(finer.out.find("export-walls-unknown"), std::string::npos);
    EXPECT_GT(finer.json()["rimTilesUnknown"], 0);
}

/// Where the walls of a mesh are between the points of the map, its facets say.
TEST_F(CliStock, WallsOfAMeshCountInWhatIsRemoved) {
    ASSERT_EQ(simulate("cylinder:d=30,h=10", "--grid 0.1 --stl c.stl", "above.nc").exitCode, 0);
    write("face.nc", "T1 M6\nG0 X-10 Y-10 Z5\nG1 Z-2 F100\nX40 Y-10\nY40\nX-10\nY-10\nX15 Y15\nG0 Z5\nM30\n");
    const auto removed = [&](const std::string& options) {
        const auto done = simulate("stl:file=c.stl", "--allow-outside " + options, "face.nc");
        return done.json()["removedMm3"].get<double>();
    };
    const double exact = removed("--grid 0.05");
    EXPECT_NEAR(removed("--grid 0.5"), exact, 3e-3 * exact);
    EXPECT_NEAR(removed("--grid 0.1"), exact, 2e-3 * exact);
}

TEST_F(CliStock, AnOutlineOfABoxIsTheBox) {
    const auto box = simulate("40x30x10", "--grid 0.5");
    const auto outline = simulate("outline:file=plate.csv,h=10", "--grid 0.5");
    ASSERT_EQ(outline.exitCode, 0) << outline.err;
    EXPECT_EQ(outline.json()["removedMm3"], box.json()["removedMm3"]);
    EXPECT_EQ(outline.json()["facesDecimated"], box.json()["facesDecimated"]);
}

TEST_F(CliStock, TheNextSetupContinuesWhereThisOneEnds) {
    const auto first = simulate("40x30x10", "--grid 0.5 --save-stock one.pvstock --zmap one.npy");
    ASSERT_EQ(first.exitCode, 0) << first.err;
    // The same program again removes nothing, on the grid stored in the file.
    const auto again = simulate("file:file=one.pvstock", "--zmap two.npy");
    ASSERT_EQ(again.exitCode, 0) << again.err;
    EXPECT_EQ(again.json()["removedMm3"], 0);
    for (const char* key : {"nx", "ny", "hx", "hy", "spacing"})
        EXPECT_EQ(again.json()["grid"][key], first.json()["grid"][key]) << key;
    EXPECT_EQ(read("two.npy"), read("one.npy"));
    // In a job, and at another path if the job is elsewhere.
    write("j.proveout", R"({"proveout": 1, "program": "p.nc", "tools": {"1": "ball:d=4,l=20"},
                            "stock": {"shape": "file", "file": "one.pvstock", "turn": "180"}})");
    const auto turned = run("simulate --job j.proveout --json");
    EXPECT_GT(turned.json()["removedMm3"].get<double>(), 0);
    const auto flipped = simulate("file:file=one.pvstock,flip=x");
    EXPECT_EQ(flipped.exitCode, 2);
    ASSERT_EQ(flipped.json()["unverified"].size(), 1U);
    EXPECT_EQ(flipped.json()["unverified"][0]["id"], "stock-undercut");
    EXPECT_EQ(flipped.json()["unverified"][0]["file"], "one.pvstock");
    const auto resampled = simulate("file:file=one.pvstock", "--grid 0.7");
    EXPECT_EQ(resampled.json()["findings"][0]["id"], "stock-resampled");
    EXPECT_EQ(resampled.exitCode, 0);
}

TEST_F(CliStock, DefectsOfAMeshAreFindingsWithTheirCounts) {
    ASSERT_EQ(simulate("40x30x10", "--grid 0.5 --mesh full --ascii --stl c.stl", "above.nc").exitCode, 0);
    EXPECT_TRUE(simulate("stl:file=c.stl", "--grid 0.5", "above.nc").json()["findings"].empty());
    // Without the last facet, and with the first one twice.
    std::string text = read("c.stl");
    text.erase(text.rfind("facet normal"));
    const std::size_t first = text.find("facet normal");
    text.insert(first, text.substr(first, text.find("facet normal", first + 1) - first));
    write("d.stl", text + "endsolid\n");
    const auto findings = simulate("stl:file=d.stl", "--grid 0.5", "above.nc").json()["findings"];
    std::map<std::string, std::string> reported;
    for (const auto& finding : findings)
        reported[finding["id"]] = finding["message"];
    EXPECT_TRUE(reported["stl-duplicate-facets"].starts_with("1 of "));
    EXPECT_EQ(reported["stl-not-closed"], "The mesh is not closed: 3 edges belong to only one facet.");
    EXPECT_EQ(reported["stl-not-manifold"],
              "The mesh is not manifold: 3 edges belong to more than two facets.");
}

TEST_F(CliStock, WrongStockIsUnusable) {
    EXPECT_EQ(simulate("cylinder:d=30").exitCode, 3);
    EXPECT_EQ(simulate("stl:file=none.stl").exitCode, 3);
    EXPECT_TRUE(simulate("file:file=p.nc").reports("p.nc:", "file-not-zip"));
    EXPECT_TRUE(simulate("cylinder:r=30").reports("proveout-cli: error: --stock:", "stock-key-unknown"));
    const auto same = simulate("outline:file=plate.csv,h=10", "--save-stock plate.csv");
    EXPECT_EQ(same.exitCode, 3); // would overwrite an input
    write("j.proveout", R"({"proveout": 1, "program": "p.nc", "tools": {"1": "ball:d=4,l=20"},
                            "stock": {"shape": "stl", "file": "none.stl"}})");
    const auto missing = run("simulate --job j.proveout");
    EXPECT_EQ(missing.exitCode, 3);
    EXPECT_NE(missing.err.find("none.stl"), std::string::npos);
    write("k.proveout", R"({"proveout": 1, "program": "p.nc", "stock": {"shape": "cone", "turn": "45"}})");
    const auto shape = run("simulate --job k.proveout");
    EXPECT_NE(shape.err.find("stock.shape"), std::string::npos) << shape.err;
}

} // namespace
} // namespace proveout
