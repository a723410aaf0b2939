// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstddef>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "resources/samples/core_insert.h"
#include "resources/samples/mouse_case.h"
#include "resources/samples/samples.h"
#include "tests/resources/plain_cut.h"

namespace proveout::samples {
namespace {

constexpr std::size_t kRoughBlocksOfMouse = 2000;

std::string committed(const std::string& name) {
    std::ifstream file(std::string(PROVEOUT_SOURCE_DIR) + "/resources/samples/" + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

struct Sample {
    const char* name;
    std::size_t blocks;
    int depth;
    std::function<double(double, double)> design;
};

void PrintTo(const Sample& sample, std::ostream* out) {
    *out << sample.name;
}

class SampleProgram : public testing::TestWithParam<Sample> {
protected:
    const std::vector<PlainMove> m_moves = readMoves(committed(GetParam().name));
};

TEST(Samples, AreWhatTheGeneratorWrites) {
    for (const SampleFile& file : sampleFiles())
        EXPECT_TRUE(committed(file.name) == file.text) << file.name << " differs: run generate_samples";
}

TEST_P(SampleProgram, HasThePapersNumberOfBlocks) {
    EXPECT_EQ(m_moves.size(), GetParam().blocks);
}

TEST_P(SampleProgram, StartsAboveTheStockWithAllAxesKnown) {
    const Vec3 start = m_moves.front().tips.front();
    EXPECT_TRUE(std::isfinite(start.x) && std::isfinite(start.y));
    EXPECT_GT(start.z, 0);
    EXPECT_TRUE(m_moves.front().rapid);
}

TEST_P(SampleProgram, StaysOverTheStockAndAboveItsFloor) {
    for (const PlainMove& move : m_moves) {
        for (const Vec3& tip : move.tips) {
            ASSERT_TRUE(tip.x >= -10 && tip.x <= 150 && tip.y >= -10 && tip.y <= GetParam().depth + 10)
                << "line " << move.line;
            ASSERT_GT(tip.z, -50) << "line " << move.line;
        }
    }
}

TEST_P(SampleProgram, NeverCutsInRapidNorIntoTheDesign) {
    PlainStock stock(140, GetParam().depth);
    for (const PlainMove& move : m_moves) {
        double removed = 0;
        for (const Vec3& tip : move.tips)
            removed = std::max(removed, stock.cut(tip));
        // The cutter may slide along a wall that it has just cut.
        ASSERT_FALSE(move.rapid && removed > 1e-3) << "rapid cuts " << removed << " mm, line " << move.line;
        if (removed > 0) {
            for (const Vec3& tip : move.tips) {
                const auto x = static_cast<int>(std::lround(tip.x));
                const auto y = static_cast<int>(std::lround(tip.y));
                if (x >= 0 && y >= 0 && x <= 140 && y <= GetParam().depth) {
                    ASSERT_GE(stock.height(x, y), GetParam().design(x, y)) << "gouge, line " << move.line;
                }
            }
        }
    }
    for (int y = 0; y <= GetParam().depth; ++y)
        for (int x = 0; x <= 140; ++x)
            ASSERT_GE(stock.height(x, y), GetParam().design(x, y)) << "gouge at " << x << ", " << y;
}

INSTANTIATE_TEST_SUITE_P(Both, SampleProgram,
                         testing::Values(Sample{"core-insert.nc", 255, 140, coreInsertHeight},
                                         Sample{"mouse-case.nc", 10273, 100, mouseCaseHeight}),
                         [](const testing::TestParamInfo<Sample>& each) {
                             return std::string(each.index == 0 ? "CoreInsert" : "MouseCase");
                         });

TEST(MouseCase, RoughingLeavesTerracesAndFinishingOnlyCusps) {
    const std::vector<PlainMove> moves = readMoves(committed("mouse-case.nc"));
    PlainStock stock(140, 100);
    double meanExcess[2] = {0, 0};
    for (std::size_t k = 0; k < moves.size(); ++k) {
        for (const Vec3& tip : moves[k].tips)
            stock.cut(tip);
        if (k + 1 == kRoughBlocksOfMouse || k + 1 == moves.size()) {
            double& mean = meanExcess[k + 1 == moves.size() ? 1 : 0];
            for (int y = 0; y <= 100; ++y)
                for (int x = 0; x <= 140; ++x)
                    mean += (stock.height(x, y) - mouseCaseHeight(x, y)) / (101.0 * 141.0);
        }
    }
    EXPECT_GT(meanExcess[0], 0.5); // the allowance plus the scallops between levels and rows
    EXPECT_LT(meanExcess[0], 3.0);
    EXPECT_LT(meanExcess[1], 0.3); // fillets smaller than the ball remain
}

} // namespace
} // namespace proveout::samples
