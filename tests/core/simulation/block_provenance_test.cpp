// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/block_provenance.h"

#include <gtest/gtest.h>
#include <stop_token>
#include <vector>

#include "tests/core/simulation/moments.h"
#include "tests/core/simulation/programs.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

/// The last block that lowered each point, by looking at the map after each block.
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
                continue; // a cutter may have passed at the very top
            ++asked;
            ASSERT_TRUE(block) << i << "," << j;
            EXPECT_LE(*block, mark - 1);
            // An earlier one only where it was lower by less than can be told apart.
            const auto until = blockProvenance(m_uncut, *m_program, *m_setup, *block + 1);
            ASSERT_TRUE(until);
            EXPECT_EQ(*block + 1 == mark || until->at(i, j) == *block + 1, true) << i << "," << j;
        }
    }
    EXPECT_GT(asked, 20);
}

TEST_F(BlockProvenance, StopsWhereItIsTold) {
    std::stop_source source;
    source.request_stop();
    WorkContext context;
    context.stop = source.get_token();
    EXPECT_FALSE(blockProvenance(m_uncut, *m_program, *m_setup, m_program->blockCount(), context));
    EXPECT_FALSE(blockThatMade(*m_program, *m_setup, m_program->blockCount(), {10, 10, -5}, context.stop));
}

} // namespace
} // namespace proveout
