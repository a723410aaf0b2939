// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the graphics memory's limit that need no OpenGL, against brute force.
#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <vector>

#include <QTest>

#include "tests/random_seed.h"
#include "ui/gl/coarse_points.h"
#include "ui/gl/graphics_shares.h"
#include "ui/gl/page_residency.h"
#include "ui/gl/point_table.h"
#include "ui/gl/visible_pages.h"
#include "ui/viewport/camera.h"

using namespace proveout;

namespace {

Grid gridOf(int nx, int ny) {
    Grid grid;
    grid.nx = nx;
    grid.ny = ny;
    return grid;
}

int between(std::mt19937& random, int lo, int hi) {
    return std::uniform_int_distribution(lo, hi)(random);
}

} // namespace

class GraphicsMemoryTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { qInfo("seed %u", m_seed); }
    void coarserPointsAreEachStepAndTheLast();
    void coarserPointsFitTheirBytes();
    void coarserTrianglesOfRegionsAreCountedOneByOne();
    void sharesNeverExceedTheWhole();
    void noShareExceedsOneTexture();
    void pagesStayUntilTheirSlotIsNeeded();
    void thePageNotNeededForLongestGoes();
    void tableFindsWhatAMapFinds();
    void everyPointInTheViewIsInAVisiblePage();
    void pagesAreHeldAllOrThoseThatShow();

private:
    std::uint32_t m_seed = randomSeed();
};

void GraphicsMemoryTest::coarserPointsAreEachStepAndTheLast() {
    for (int count = 2; count < 70; ++count)
        for (const int step : {1, 2, 4, 16, 128}) {
            std::vector<int> expected;
            for (int point = 0; point < count; ++point)
                if (point % step == 0 || point == count - 1)
                    expected.push_back(point);
            QCOMPARE(CoarsePoints::of(gridOf(count, 2), step).count.x, static_cast<int>(expected.size()));
            for (int from = 0; from < count; from += 5) {
                const int to = std::min(from + 5, count);
                const SampledPoints part = sampledPoints(from, to, count, step);
                for (std::size_t k = 0; k < part.points.size(); ++k)
                    QCOMPARE(part.points[k], expected[static_cast<std::size_t>(part.first) + k]);
                const auto in = std::ranges::count_if(expected, [&](int p) { return p >= from && p < to; });
                QCOMPARE(static_cast<std::ptrdiff_t>(part.points.size()), in);
            }
        }
}

void GraphicsMemoryTest::coarserPointsFitTheirBytes() {
    const Grid panel = gridOf(20001, 10001);
    const CoarsePoints points = CoarsePoints::within(panel, 60'000'000, 16384);
    QCOMPARE(points.step, 4);
    QVERIFY(CoarsePoints::of(panel, 2).bytes() > 60'000'000);
    QCOMPARE(CoarsePoints::within(gridOf(1'000'000, 1000), 60'000'000, 16384).step, 64);
}

void GraphicsMemoryTest::coarserTrianglesOfRegionsAreCountedOneByOne() {
    for (const int cells : {1, 3, 7, 10, 16, 40})
        for (const RegionGrid& regions : {RegionGrid(41, 30, cells), RegionGrid(50, 2, cells)}) {
            const auto counted = [&](int step) {
                std::size_t triangles = 0;
                for (std::size_t region = 0; region < regions.regionCount(); ++region) {
                    const IndexRect points = regions.points(region);
                    std::size_t columns = 0;
                    std::size_t rows = 0;
                    for (int i = points.i0; i < points.i1 - 1; i += step)
                        ++columns;
                    for (int j = points.j0; j < points.j1 - 1; j += step)
                        ++rows;
                    triangles += 2 * columns * rows;
                }
                return triangles;
            };
            for (const int step : {1, 2, 4, 8, 64})
                QCOMPARE(coarseTriangles(regions, step), counted(step));
            for (const std::size_t most : {5UL, 100UL, 300UL, 1000UL, 5000UL}) {
                const int step = stepWithin(regions, most);
                QVERIFY(counted(step) <= most || counted(step) == 2 * regions.regionCount());
                QVERIFY(step == 1 || counted(step / 2) > most);
            }
        }
}

void GraphicsMemoryTest::sharesNeverExceedTheWhole() {
    std::mt19937 random(m_seed);
    for (int round = 0; round < 2000; ++round) {
        const Grid grid = gridOf(between(random, 100, 30'000), between(random, 100, 30'000));
        const auto bytes = static_cast<std::size_t>(between(random, 200'000, 2'000'000'000));
        const int layers = between(random, 256, 2048);
        const GraphicsShares shares = GraphicsShares::of(grid, bytes, {8192, layers});
        const HeightPages pages = HeightPages::ofSide(grid, shares.pagePoints);
        const std::size_t held = shares.coarse + shares.lists + shares.walls + shares.vertices +
                                 shares.slotCount * shares.pageBytes() +
                                 2 * static_cast<std::size_t>(pages.count());
        // The texture that names the pages' layers may be the only thing that does not fit.
        QVERIFY(held <= bytes || shares.slotCount == 0);
        QVERIFY(shares.slotCount <= static_cast<std::size_t>(layers));
        QVERIFY(pages.texels().x <= 8192);
        QVERIFY(shares.vertices <= 8192 * PointTable::kRow * sizeof(PointTable::Entry)); // rows of a texture
        QCOMPARE(shares.coarse, CoarsePoints::of(grid, shares.coarseStep).bytes());
    }
}

void GraphicsMemoryTest::noShareExceedsOneTexture() {
    std::mt19937 random(m_seed);
    for (int round = 0; round < 500; ++round) {
        const Grid grid = gridOf(between(random, 1000, 30'000), between(random, 1000, 30'000));
        const auto most = static_cast<std::size_t>(between(random, 10'000'000, 100'000'000));
        const GraphicsShares shares = GraphicsShares::of(grid, 1'000'000'000, {8192, 2048, most});
        QVERIFY(shares.coarse <= most && shares.vertices <= most);
        QVERIFY(shares.slotCount > 0 && shares.slotCount * shares.pageBytes() <= most);
        QVERIFY(shares.lists == 200'000'000); // buffers grow, and are not created in one piece
    }
}

void GraphicsMemoryTest::pagesStayUntilTheirSlotIsNeeded() {
    std::mt19937 random(m_seed);
    PageResidency residency;
    residency.reset(40, 10);
    std::map<int, int> pageIn; // by slot
    for (int round = 0; round < 500; ++round) {
        std::set<int> needed;
        const int count = between(random, 0, 14);
        while (std::ssize(needed) < count)
            needed.insert(between(random, 0, 39));
        std::vector<int> order(needed.begin(), needed.end());
        std::ranges::shuffle(order, random);
        residency.need(order);
        while (const auto load = residency.nextLoad()) {
            QVERIFY(needed.contains(load->page));
            QVERIFY(load->slot >= 0 && load->slot < 10);
            QVERIFY(!needed.contains(load->evicted));
            QCOMPARE(load->evicted, pageIn.contains(load->slot) ? pageIn[load->slot] : PageResidency::kNone);
            pageIn[load->slot] = load->page;
        }
        int held = 0;
        for (const int page : needed)
            held += residency.holds(page) ? 1 : 0;
        QCOMPARE(held, std::min(count, 10));
        for (int page = 0; page < 40; ++page) {
            const auto in =
                std::ranges::find_if(pageIn, [&](const auto& each) { return each.second == page; });
            QCOMPARE(residency.slotOf(page), in == pageIn.end() ? PageResidency::kNone : in->first);
        }
    }
}

void GraphicsMemoryTest::thePageNotNeededForLongestGoes() {
    PageResidency residency;
    residency.reset(9, 3);
    const auto need = [&](std::vector<int> pages) {
        residency.need(pages);
        while (residency.nextLoad()) {
        }
    };
    need({0, 1, 2});
    need({0, 2});
    need({2});
    need({5});
    QVERIFY(residency.holds(0) && residency.holds(2) && !residency.holds(1));
    need({6});
    QVERIFY(!residency.holds(0) && residency.holds(2));
}

void GraphicsMemoryTest::tableFindsWhatAMapFinds() {
    std::mt19937 random(m_seed);
    PointTable table;
    table.reset(3 * PointTable::kRow * sizeof(PointTable::Entry)); // rounded down to two rows
    QCOMPARE(table.rows(), std::size_t{2});
    std::map<std::uint32_t, float> expected;
    for (int round = 0; round < 5000; ++round) {
        const auto point = static_cast<std::uint32_t>(between(random, 0, 3000) * 65536);
        const auto height = static_cast<float>(between(random, -100, 0));
        if (between(random, 0, 1) == 0) {
            const bool added = table.add(point, height);
            QCOMPARE(added, expected.contains(point) || expected.size() < PointTable::kRow);
            if (added)
                expected[point] = height;
        } else {
            table.set(point, height);
            if (expected.contains(point))
                expected[point] = height;
        }
    }
    std::map<std::uint32_t, float> found;
    for (std::size_t row = 0; row < table.rows(); ++row)
        for (const PointTable::Entry& entry : table.row(row))
            if (entry.point != PointTable::kNoPoint)
                found[entry.point] = entry.height;
    QVERIFY(found == expected);
    QCOMPARE(table.takeChangedRows().size(), std::size_t{2});
    QVERIFY(table.takeChangedRows().empty());
    table.set(expected.begin()->first, 7);
    QCOMPARE(table.takeChangedRows().size(), std::size_t{1});
}

void GraphicsMemoryTest::everyPointInTheViewIsInAVisiblePage() {
    std::mt19937 random(m_seed);
    Grid grid = gridOf(301, 201);
    grid.hx = grid.hy = 0.5;
    const double height = 20;
    Box3 stock;
    stock.add(Vec3(0, 0, 0));
    stock.add(Vec3(150, 100, height));
    const HeightPages pages = HeightPages::ofSide(grid, 16);
    std::vector<PageHeights> heights;
    for (int page = 0; page < pages.count(); ++page)
        heights.push_back(
            {static_cast<double>(between(random, 0, 9)), static_cast<double>(between(random, 10, 20))});
    for (int round = 0; round < 100; ++round) {
        Camera camera;
        camera.setPicture(320, 200, 1);
        camera.setPerspective(round % 2 == 0);
        camera.setStandardView(static_cast<StandardView>(between(random, 0, kStandardViews - 1)));
        camera.fit(stock);
        camera.zoom(between(random, 2, 100) * 0.01,
                    {between(random, 0, 150), between(random, 0, 100), height});
        const glm::dmat4 clipFromStock = camera.view(stock).clipFromWorld;
        const std::vector<VisiblePage> visible =
            visiblePages(grid, pages, heights, {clipFromStock, {320, 200}});
        std::set<int> listed;
        for (const VisiblePage& page : visible)
            listed.insert(page.page);
        for (int j = 0; j < grid.ny; j += 3)
            for (int i = 0; i < grid.nx; i += 3) {
                const int page = (j / 16) * pages.columns + i / 16;
                const PageHeights& seen = heights[static_cast<std::size_t>(page)];
                const double z = std::uniform_real_distribution(seen.lowest, seen.highest)(random);
                const glm::dvec4 clip = clipFromStock * glm::dvec4(grid.hx * i, grid.hy * j, z, 1);
                if (clip.w > 0 && std::abs(clip.x) < clip.w && std::abs(clip.y) < clip.w)
                    QVERIFY(listed.contains(page));
            }
        QVERIFY(std::ranges::is_sorted(visible, std::greater<>(), &VisiblePage::pixels));
    }
}

void GraphicsMemoryTest::pagesAreHeldAllOrThoseThatShow() {
    const std::vector<VisiblePage> visible{{3, 2.0}, {1, 0.4}, {2, 0.3}, {7, 0.1}};
    QCOMPARE(pagesToHold(visible, 4, 4), (std::vector{3, 1, 2, 7}));
    QCOMPARE(pagesToHold(visible, 4, 3), (std::vector{3, 1, 2})); // 0.1 × 4 is less than a pixel
    QCOMPARE(pagesToHold(visible, 2, 3), (std::vector{3}));
    QCOMPARE(pagesToHold(visible, 4, 1), (std::vector{3}));
}

QTEST_APPLESS_MAIN(GraphicsMemoryTest)
#include "graphics_memory_test.moc"
