// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gmock/gmock.h>
#include <limits>

#include "core/formats/npy.h"
#include "core/formats/stl.h"
#include "tests/app/command_line.h"

namespace proveout {
namespace {

using testing::HasSubstr;

class CliDecimate : public CommandLine {
protected:
    /// A bowl of `columns` × `rows` points, absolute heights around 100 mm.
    void writeBowl(const std::string& name, int columns, int rows) {
        NpyArray array{rows, columns, {}};
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i)
                array.values.push_back(100 + 0.01 * std::pow(i - 20, 2) + 0.02 * std::pow(j - 10, 2));
        ASSERT_TRUE(writeNpy(folder / name, array));
    }
};

TEST_F(CliDecimate, JsonHasTheKeysOfTheContract) {
    writeBowl("a.npy", 41, 33);
    const auto done = run("decimate a.npy --grid 0.5 --allowance 0.05 --json");
    ASSERT_EQ(done.exitCode, 0) << done.err;
    const auto json = done.json();
    EXPECT_EQ(json["facesIn"], 2 * 40 * 32);
    EXPECT_LT(json["facesOut"], json["facesIn"]);
    EXPECT_GE(json["seconds"], 0);
    EXPECT_LE(json["largestErrorMm"], 0.05);
    EXPECT_GT(json["largestErrorMm"], 0);
    EXPECT_EQ(json["errorLevel"], "surface");
    EXPECT_EQ(json["regions"], 3 * 2);
    EXPECT_EQ(json["method"], "certified");
    const auto sample = run("decimate a.npy --grid 0.5 --level sample --json").json();
    EXPECT_EQ(sample["errorLevel"], "sample");
    EXPECT_LE(sample["facesOut"], json["facesOut"]);
    const auto lee = run("decimate a.npy --grid 0.5 --method lee --json").json();
    EXPECT_EQ(lee["errorLevel"], "sample");
    EXPECT_EQ(lee["regions"], 5 * 4);
    EXPECT_EQ(run("decimate a.npy --grid 0.5 --method lee --no-certify --json").json()["errorLevel"],
              "measured");
    EXPECT_EQ(run("decimate a.npy --grid 0.5 --region 16 --json").json()["regions"], 3 * 2);
    EXPECT_EQ(run("decimate a.npy --grid 0.5 --method global --json").json()["regions"], 1);
}

TEST_F(CliDecimate, SolidLiesAtOriginAndFloor) {
    writeBowl("a.npy", 41, 33);
    ASSERT_EQ(run("decimate a.npy --grid 0.5 --origin -3,7 --floor 90 --stl a.stl").exitCode, 0);
    const auto mesh = readStl(folder / "a.stl");
    ASSERT_TRUE(mesh);
    Box3 box;
    for (const auto& vertex : mesh->vertices)
        box.add(vertex);
    EXPECT_NEAR(box.lo.x, -3, 1e-5);
    EXPECT_NEAR(box.hi.x, 17, 1e-5);
    EXPECT_NEAR(box.lo.y, 7, 1e-5);
    EXPECT_NEAR(box.hi.y, 23, 1e-5);
    EXPECT_NEAR(box.lo.z, 90, 1e-5);
    EXPECT_NEAR(box.hi.z, 100 + 0.01 * 400 + 0.02 * 484, 1e-4);
    ASSERT_EQ(run("decimate a.npy --grid 0.5 --stl b.stl").exitCode, 0);
    Box3 standard;
    const auto onStandardFloor = readStl(folder / "b.stl");
    ASSERT_TRUE(onStandardFloor);
    for (const auto& vertex : onStandardFloor->vertices)
        standard.add(vertex);
    EXPECT_NEAR(standard.lo.z, 95, 1e-4) << "5 mm below the least height";
}

TEST_F(CliDecimate, RefusesHeightsThatAreNone) {
    NpyArray bad{3, 3, {0, 0, 0, 0, 0, std::numeric_limits<double>::quiet_NaN(), 0, 0, 0}};
    ASSERT_TRUE(writeNpy(folder / "nan.npy", bad));
    const auto nan = run("decimate nan.npy --grid 1");
    EXPECT_EQ(nan.exitCode, 3);
    EXPECT_THAT(nan.err, HasSubstr("ow 1, column 2"));
    ASSERT_TRUE(writeNpy(folder / "thin.npy", {1, 5, {0, 0, 0, 0, 0}}));
    EXPECT_EQ(run("decimate thin.npy --grid 1").exitCode, 3);
    writeBowl("a.npy", 5, 5);
    EXPECT_EQ(run("decimate a.npy --grid 1 --floor 104").exitCode, 3);
    EXPECT_EQ(run("decimate a.npy --grid 1 --stl a.npy").exitCode, 3);
    EXPECT_EQ(run("decimate a.npy --grid 1 --stl none/a.stl").exitCode, 3);
    EXPECT_EQ(run("decimate a.npy --grid 1 --borders paper --stl a.stl").exitCode, 3);
    write("text.npy", "no array");
    EXPECT_EQ(run("decimate text.npy --grid 1").exitCode, 3);
}

TEST_F(CliDecimate, FailuresAreInTheJsonToo) {
    writeBowl("a.npy", 5, 5);
    const auto missing = run("decimate none.npy --grid 1 --json");
    EXPECT_EQ(missing.json()["findings"][0]["id"], "file-unreadable");
    EXPECT_TRUE(missing.json()["unverified"].empty());
    const auto cracks = run("decimate a.npy --grid 1 --borders paper --stl a.stl --json");
    EXPECT_EQ(cracks.json()["findings"][0]["id"], "borders-not-exported");
    EXPECT_FALSE(cracks.json().contains("facesOut")) << "refused before the work";
    const auto unwritable = run("decimate a.npy --grid 1 --stl none/a.stl --json");
    EXPECT_EQ(unwritable.json()["findings"][0]["id"], "file-unwritable");
    EXPECT_EQ(run("decimate a.npy --grid 1e-300 --json").json()["findings"][0]["id"],
              "grid-lost-in-rounding");
}

TEST_F(CliDecimate, FlatMapsAndTheSmallestMapWork) {
    ASSERT_TRUE(writeNpy(folder / "flat.npy", {2, 2, {1, 1, 1, 1}}));
    const auto done = run("decimate flat.npy --grid 1 --stl a.stl --json");
    EXPECT_EQ(done.exitCode, 0) << done.err;
    EXPECT_EQ(done.json()["facesOut"], 2);
    EXPECT_TRUE(exists("a.stl"));
}

} // namespace
} // namespace proveout
