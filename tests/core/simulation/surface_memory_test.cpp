// SPDX-License-Identifier: GPL-3.0-or-later
// A surface that needs more memory than is allowed is given up; the stock is cut and shown nevertheless.
#include <algorithm>
#include <cstring>
#include <gtest/gtest.h>
#include <new>
#include <string_view>
#include <sys/mman.h>
#include <utility>
#include <vector>

#include "core/simulation/setup/setup_memory.h"
#include "tests/core/simulation/moments.h"
#include "tests/core/simulation/programs.h"

namespace proveout {
namespace {

/// 481,000 points: the memory is looked at when their regions are decimated for the first time.
std::shared_ptr<const Setup> manyPoints() {
    return smallSetup(0.05);
}

/// Memory from the system: what malloc has kept of freed memory would not make the process larger.
class Taken {
public:
    explicit Taken(std::size_t bytes)
        : m_bytes(bytes),
          m_pages(mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)) {
        if (m_pages == MAP_FAILED)
            throw std::bad_alloc();
        std::memset(m_pages, 1, m_bytes);
    }
    ~Taken() { munmap(m_pages, m_bytes); }
    Taken(const Taken&) = delete;
    Taken& operator=(const Taken&) = delete;

private:
    std::size_t m_bytes;
    void* m_pages;
};

constexpr std::size_t kMuch = 64'000'000;

/// From now on the process takes more than what it may.
[[nodiscard]] Taken useUp(Simulation& simulation) {
    simulation.allowMemory(0);
    return Taken(kMuch);
}

bool hasFinding(const Frame& frame) {
    return std::ranges::any_of(frame.findings, [](const Diagnostic& finding) {
        return std::string_view(finding.id) == "surface-too-large";
    });
}

TEST(SurfaceMemory, GivesUpASurfaceThatIsTooLargeAndCutsOn) {
    const auto program = programOf(randomProgram(1, 60));
    const auto allowed = startedSimulation(program, manyPoints(), {});
    auto limited = Simulation::prepare(program, manyPoints(), {}).value();
    const auto more = useUp(*limited);
    for (const std::size_t block : {0, 1, 23, 60, 11, 12}) {
        if (limited->position() + 1 == block)
            limited->step();
        else
            limited->seek(block);
        allowed->seek(block);
        const Frame frame = limited->frame();
        EXPECT_TRUE(limited->settled());
        EXPECT_FALSE(limited->canRefine());
        EXPECT_TRUE(hasFinding(frame));
        EXPECT_EQ(frame.block, block);
        EXPECT_EQ(frame.surface.dirtyRegions, frame.surface.grid.regionCount());
        EXPECT_EQ(frame.surface.faces, frame.surface.facesFull);
        EXPECT_TRUE(sameZMap(frame.zmap, allowed->frame().zmap));
    }
    EXPECT_FALSE(hasFinding(allowed->frame()));
}

TEST(SurfaceMemory, IsKeptIfOtherWorkOfTheProcessTakesTheMemory) {
    constexpr std::size_t kBlocks = 60;
    const auto program = programOf(randomProgram(6, kBlocks));
    const auto setup = manyPoints();
    const Grid grid = makeGrid(setup->stock, setup->spacing).value();
    const auto enough = static_cast<std::size_t>(0.9 * memoryForecast(*setup, grid, {}, true).most);
    auto simulation = Simulation::prepare(program, setup, {}).value();
    simulation->allowMemory(enough);
    const Taken ofAnExport(enough + kMuch);
    simulation->seek(20);
    simulation->play(kBlocks);
    EXPECT_TRUE(simulation->settled());
    EXPECT_FALSE(hasFinding(simulation->frame()));
    const auto alone = startedSimulation(program, setup, {});
    alone->seek(20);
    alone->play(kBlocks);
    EXPECT_EQ(difference(simulation->frame(), alone->frame()), "");
}

TEST(SurfaceMemory, IsGivenUpForTheTrianglesOfItsOwn) {
    const auto program = programOf(randomProgram(7, 60));
    const auto setup = manyPoints();
    const auto alone = startedSimulation(program, setup, {});
    alone->seek(60);
    const std::size_t faces = alone->frame().surface.faces;
    const Grid grid = makeGrid(setup->stock, setup->spacing).value();
    for (const auto& [counted, isGivenUp] :
         std::vector<std::pair<std::size_t, bool>>{{faces / 10, true}, {10 * faces, false}}) {
        auto simulation = Simulation::prepare(program, setup, {}).value();
        const auto most =
            static_cast<std::size_t>(scheduledBytes(grid, {}, simulationOutputs(*setup, true), counted));
        simulation->allowMemory(most);
        const Taken ofAnExport(most + kMuch);
        simulation->seek(60);
        EXPECT_EQ(hasFinding(simulation->frame()), isGivenUp) << counted << " of " << faces;
    }
}

TEST(SurfaceMemory, IsDecimatedAgainWithOtherParameters) {
    const auto program = programOf(randomProgram(2, 60));
    auto simulation = Simulation::prepare(program, manyPoints(), {}).value();
    const auto more = useUp(*simulation);
    simulation->seek(40);
    ASSERT_TRUE(hasFinding(simulation->frame()));
    simulation->allowMemory(UINT64_MAX / 2);
    DecimationParameters larger;
    larger.allowance = 0.1;
    apply(*simulation, larger);
    EXPECT_FALSE(hasFinding(simulation->frame()));
    const auto fresh = startedSimulation(program, manyPoints(), larger);
    fresh->seek(40);
    EXPECT_EQ(difference(simulation->frame(), fresh->frame()), "");
}

TEST(SurfaceMemory, IsGivenUpWhileAProgramIsPlayed) {
    constexpr std::size_t kBlocks = 300;
    const auto program = programOf(randomProgram(5, kBlocks));
    const auto played = startedSimulation(program, manyPoints(), {});
    const auto more = useUp(*played); // the uncut stock was decimated before
    played->play(kBlocks);
    EXPECT_TRUE(played->settled());
    EXPECT_TRUE(hasFinding(played->frame()));
    const auto fresh = startedSimulation(program, manyPoints(), {});
    fresh->seek(kBlocks);
    EXPECT_EQ(played->position(), kBlocks);
    EXPECT_TRUE(sameZMap(played->frame().zmap, fresh->frame().zmap));
    EXPECT_EQ(played->frame().findings.size(), fresh->frame().findings.size() + 1);
    for (std::size_t block = 0; block < kBlocks; ++block)
        EXPECT_EQ(played->rows()[block].removedMm3, fresh->rows()[block].removedMm3) << block;
    for (std::size_t block = 0; block < kBlocks; ++block)
        EXPECT_TRUE(played->rows()[block].isPlayed()) << block;
}

TEST(SurfaceMemory, OfAnEditedProgramStaysGivenUp) {
    auto simulation = Simulation::prepare(programOf(randomProgram(3, 60)), manyPoints(), {}).value();
    const auto more = useUp(*simulation);
    simulation->seek(40);
    const auto edited = programOf(randomProgram(4, 60));
    apply(*simulation, edited);
    simulation->seek(60);
    EXPECT_TRUE(simulation->settled());
    EXPECT_TRUE(hasFinding(simulation->frame()));
    const auto fresh = startedSimulation(edited, manyPoints(), {});
    fresh->seek(60);
    EXPECT_TRUE(sameZMap(simulation->frame().zmap, fresh->frame().zmap));
}

TEST(SetupMemory, RequiresOnlyTheMapsAndNamesTheExpectedAndTheMost) {
    proveout::Setup setup = *smallSetup(0.01);
    const Grid grid = makeGrid(setup.stock, setup.spacing).value();
    const MemoryForecast forecast = memoryForecast(setup, grid, {});
    EXPECT_GT(forecast.expected, 2 * zmapBytes(grid)) << "the map, and that of the last moment";
    EXPECT_LT(forecast.expected, 0.7 * forecast.most);
    EXPECT_TRUE(checkSetupMemory(setup, {}, forecast.expected));
    EXPECT_FALSE(checkSetupMemory(setup, {}, zmapBytes(grid)));
    setup.shape.kind = StockKind::cylinder;
    EXPECT_GT(memoryForecast(setup, grid, {}).most, forecast.most) << "its uncut map is kept";
}

} // namespace
} // namespace proveout
