// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/records/block_provenance.h"

#include <cmath>
#include <gtest/gtest.h>
#include <stop_token>
#include <vector>

#include "tests/core/simulation/moments.h"
#include "tests/core/simulation/programs.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

/// The last block that lowered each point, found by comparing the z-map after each block.
std::vector<std::uint32_t> marksStepByStep(Simulation& simulation) {
    const Grid grid = simulation.zmap().grid();
    const IndexRect all{0, 0, grid.nx, grid.ny};
    const auto points = static_cast<std::size_t>(grid.nx) * static_cast<std::size_t>(grid.ny);
    std::vector<std::uint32_t> marks(points, Provenance::kUncut);
    std::vector<float> before(points);
    std::vector<float> now(points);
    simulation.zmap().read(all, before);
    while (!simulation.atEnd()) {
        simulation.step();
        simulation.zmap().read(all, now);
        for (std::size_t at = 0; at < points; ++at) {
            if (now[at] < before[at])
                marks[at] = static_cast<std::uint32_t>(simulation.position());
        }
        before.swap(now);
    }
    return marks;
}

class BlockProvenance : public testing::Test {
protected:
    const std::uint32_t m_seed = randomSeed();
    std::shared_ptr<const Program> m_program = programOf(randomProgram(m_seed, 120));
    std::shared_ptr<const proveout::Setup> m_setup = smallSetup(0.25);
    std::unique_ptr<Simulation> m_simulation = startedSimulation(m_program, m_setup, {});
    ZMapSnapshot m_uncut = m_simulation->zmap();
    std::vector<std::uint32_t> m_marks = marksStepByStep(*m_simulation);
};

TEST_F(BlockProvenance, NamesTheBlockThatLoweredEachPointLast) {
    SCOPED_TRACE(m_seed);
    const auto provenance = blockProvenance(m_uncut, *m_program, *m_setup, m_program->blockCount());
    ASSERT_TRUE(provenance);
    const Grid grid = m_uncut.grid();
    for (int j = 0; j < grid.ny; ++j) {
        for (int i = 0; i < grid.nx; ++i)
            ASSERT_EQ(provenance->at(i, j), m_marks[static_cast<std::size_t>(j * grid.nx + i)])
                << i << "," << j;
    }
}

TEST_F(BlockProvenance, NamesTheBlockThatMadeAPlace) {
    SCOPED_TRACE(m_seed);
    const ZMapSnapshot cut = m_simulation->zmap();
    const Grid grid = cut.grid();
    int asked = 0;
    for (int j = 1; j < grid.ny; j += 7) {
        for (int i = 1; i < grid.nx; i += 7) {
            const double z = cut.stock().topZ() + static_cast<double>(cut.height(i, j));
            const Vec3 place(grid.x(i), grid.y(j), z);
            const auto block = blockThatMade(*m_program, *m_setup, m_program->blockCount(), place);
            const std::uint32_t mark = m_marks[static_cast<std::size_t>(j * grid.nx + i)];
            if (mark == Provenance::kUncut)
                continue; // the cutter may have touched only the top
            ++asked;
            ASSERT_TRUE(block) << i << "," << j;
            EXPECT_LE(*block, mark - 1);
            // An earlier block is possible only if it was lower by less than the resolution.
            const auto until = blockProvenance(m_uncut, *m_program, *m_setup, *block + 1);
            ASSERT_TRUE(until);
            EXPECT_EQ(*block + 1 == mark || until->at(i, j) == *block + 1, true) << i << "," << j;
        }
    }
    EXPECT_GT(asked, 20);
}

TEST_F(BlockProvenance, NamesTheBlockThatMadeAPointOfAMap) {
    SCOPED_TRACE(m_seed);
    const Frame moment = m_simulation->frame();
    const Grid grid = moment.zmap.grid();
    int cut = 0;
    int uncut = 0;
    for (int j = 0; j < grid.ny; j += 5) {
        for (int i = 0; i < grid.nx; i += 5) {
            const float height = moment.zmap.height(i, j);
            const std::uint32_t mark = m_marks[static_cast<std::size_t>(j * grid.nx + i)];
            const auto block = blockThatMade(moment, {i, j});
            if (mark == Provenance::kUncut) {
                EXPECT_FALSE(block) << i << "," << j;
                ++uncut;
            } else if (height < -0.01F) {
                ASSERT_TRUE(block) << i << "," << j;
                ++cut;
                // That block produces the current height, within the tolerance between two exact cuts.
                EXPECT_LE(*block, mark - 1);
                m_simulation->seek(*block + 1);
                EXPECT_LE(m_simulation->zmap().height(i, j), height + 0.003F) << i << "," << j;
                m_simulation->seek(*block);
                EXPECT_GT(m_simulation->zmap().height(i, j), height + 0.001F) << i << "," << j;
            }
        }
    }
    EXPECT_GT(cut, 50);
    EXPECT_GT(uncut, 0);
}

TEST(BlockThatMade, NamesNoneOfThoseThatOnlyPassedAlongTheStock) {
    const auto setup = setupWithTool(1, "flat:d=4,l=20");
    // First along the top; then 2 mm deep with the rim on the points at Y13 and Y17.
    const auto program =
        programOf("G21 G90 T1 M6\nG0 X-5 Y5 Z5\nG1 Z0 F500\nX45\nG0 Z5\nX-5 Y15\nG1 Z-2\nX45\n");
    const auto simulation = startedSimulation(program, setup, {});
    simulation->seek(program->blockCount());
    const Frame moment = simulation->frame();
    const Grid& grid = moment.zmap.grid();
    const auto madeAt = [&](double x, double y) {
        return blockThatMade(moment, {static_cast<int>(std::lround((x - grid.x0) / grid.hx)),
                                      static_cast<int>(std::lround((y - grid.y0) / grid.hy))});
    };
    EXPECT_FALSE(madeAt(20, 5));
    EXPECT_FALSE(madeAt(20, 25));
    for (const double y : {13., 15., 17.})
        EXPECT_EQ(madeAt(20, y), program->blockCount() - 1) << y;
}

TEST_F(BlockProvenance, StopsWhereRequested) {
    std::stop_source source;
    source.request_stop();
    WorkContext context;
    context.stop = source.get_token();
    EXPECT_FALSE(blockProvenance(m_uncut, *m_program, *m_setup, m_program->blockCount(), context));
    EXPECT_FALSE(blockThatMade(*m_program, *m_setup, m_program->blockCount(), {10, 10, -5}, context));
}

} // namespace
} // namespace proveout
