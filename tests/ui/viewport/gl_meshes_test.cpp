// SPDX-License-Identifier: GPL-3.0-or-later
// What the renderer creates before anything is uploaded to the GPU.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <random>
#include <set>

#include <QTest>

#include "core/cutting/fixtures/fixture_surface.h"
#include "core/decimation/surface/refined_surface.h"
#include "tests/core/cutter/default_spec.h"
#include "tests/ui/viewport/frame_builder.h"
#include "ui/gl/cutter_mesh.h"
#include "ui/gl/fixture_mesh.h"
#include "ui/gl/path_lines.h"
#include "ui/gl/path_overview.h"
#include "ui/gl/slot_allocator.h"
#include "ui/gl/wall_buffer.h"

using namespace proveout;

class GlMeshesTest : public QObject {
    Q_OBJECT

private slots:
    void slotsNeverOverlap();
    void cutterIsClosedAndToScale_data();
    void cutterIsClosedAndToScale();
    void fixturesAreClosedAndToScale();
    void wallsCloseTheSurface();
    void wallsCloseMergedRegions();
    void pathFollowsTheMotions();
    void overviewStaysNearThePath();
    void pathIsCoarserWhereItIsManyLines();
    void pathOfAFrameHasFewMotions();
    void overviewOfManyMotionsEnds();
};

void GlMeshesTest::slotsNeverOverlap() {
    std::mt19937 random(4711);
    SlotAllocator allocator;
    std::map<std::uint32_t, SlotAllocator::Slot> taken; // by offset
    for (int step = 0; step < 20000; ++step) {
        if (!taken.empty() && random() % 2 == 0) {
            auto victim = taken.begin();
            std::advance(victim, random() % taken.size());
            allocator.free(victim->second);
            taken.erase(victim);
            continue;
        }
        const auto count = 1 + static_cast<std::uint32_t>(random() % 300);
        const SlotAllocator::Slot slot = allocator.allocate(count);
        QVERIFY(slot.capacity >= count && slot.offset + slot.capacity <= allocator.extent());
        const auto next = taken.lower_bound(slot.offset);
        QVERIFY(next == taken.end() || slot.offset + slot.capacity <= next->second.offset);
        QVERIFY(next == taken.begin() ||
                std::prev(next)->second.offset + std::prev(next)->second.capacity <= slot.offset);
        taken.emplace(slot.offset, slot);
    }
    QVERIFY(allocator.extent() < 20000u * 64u); // freed slots are reused
}

void GlMeshesTest::cutterIsClosedAndToScale_data() {
    QTest::addColumn<QString>("spec");
    for (const char* spec :
         {"ball:d=11,l=50", "flat:d=6,l=20", "bull:d=10,r=2,l=30", "cone:d=12,angle=90,l=25",
          "tslot:d=20,w=6,neck=9,r=1", "dovetail:d=20,angle=60,h=6,neck=8,r=0.5", "form:p=0/0:3/0:3/1:6/4@-3",
          "flat:d=12,l=20,sd=8,so=40,holder=30x20+30-50x30+20x10", "flat:d=12,l=20,so=10,holder=30x20",
          "tslot:d=20,w=6,neck=9,so=30,holder=40x20"})
        QTest::newRow(spec) << QString::fromLatin1(spec);
    for (const CutterShape& shape : cutterShapes())
        QTest::newRow(shape.key) << QString::fromStdString(defaultSpecOf(shape));
}

/// The distance in height of an r-z position from the profile, the back of a slot cutter or lollipop, and its
/// walls, mm.
static double distanceFromProfile(const Cutter& cutter, double r, double z) {
    std::vector<ProfilePiece> pieces = cutter.pieces();
    if (cutter.head())
        pieces.insert(pieces.end(), cutter.head()->back.begin(), cutter.head()->back.end());
    double nearest = std::abs(z - cutter.height(r));
    for (const ProfilePiece& piece : pieces)
        if (piece.r0 - 1e-4 < r && r < piece.r1 + 1e-4)
            nearest = std::min(nearest, std::abs(z - heightOf(piece, std::clamp(r, piece.r0, piece.r1))));
    return nearest;
}

void GlMeshesTest::cutterIsClosedAndToScale() {
    QFETCH(QString, spec);
    const Cutter cutter = parseCutter(spec.toStdString()).value();
    const std::vector<CutterVertex> mesh = cutterMesh(cutter);
    using Point = std::array<long, 3>;
    const auto rounded = [](const glm::vec3& p) {
        return Point{std::lround(p.x * 1e4), std::lround(p.y * 1e4), std::lround(p.z * 1e4)};
    };
    std::map<std::pair<Point, Point>, int> edges;
    double volume = 0;
    for (std::size_t k = 0; k < mesh.size(); k += 3) {
        for (std::size_t corner = 0; corner < 3; ++corner)
            ++edges[{rounded(mesh[k + corner].position), rounded(mesh[k + (corner + 1) % 3].position)}];
        volume += glm::dot(glm::dvec3(mesh[k].position),
                           glm::cross(glm::dvec3(mesh[k + 1].position), glm::dvec3(mesh[k + 2].position))) /
                  6;
    }
    for (const auto& [edge, count] : edges)
        QCOMPARE(edges[std::pair(edge.second, edge.first)], count);
    QVERIFY(volume > 0); // the triangles face outwards
    const CutterExtent extent = cutterExtent(cutter);
    float highest = 0;
    for (const CutterVertex& vertex : mesh)
        highest = std::max(highest, vertex.position.z);
    QCOMPARE(highest, static_cast<float>(extent.height));
    QVERIFY(extent.radius >= cutter.radius());
    // The fluted part is on the profile.
    for (const CutterVertex& vertex : mesh) {
        const double r = std::hypot(vertex.position.x, vertex.position.y);
        if (vertex.part < 0.5f && r < cutter.radius() * 0.999)
            QVERIFY(distanceFromProfile(cutter, r, static_cast<double>(vertex.position.z)) < 1e-3);
        QVERIFY(vertex.part > 0.5f || r <= cutter.radius() * 1.0001);
    }
}

/// The volume of a closed mesh; 0 if it is open.
template<class Vertex>
static double volumeOf(const std::vector<Vertex>& mesh) {
    using Point = std::array<long, 3>;
    const auto rounded = [](const glm::vec3& p) {
        return Point{std::lround(p.x * 1e4), std::lround(p.y * 1e4), std::lround(p.z * 1e4)};
    };
    std::map<std::pair<Point, Point>, int> edges;
    double volume = 0;
    for (std::size_t k = 0; k < mesh.size(); k += 3) {
        for (std::size_t corner = 0; corner < 3; ++corner)
            ++edges[{rounded(mesh[k + corner].position), rounded(mesh[k + (corner + 1) % 3].position)}];
        volume += glm::dot(glm::dvec3(mesh[k].position),
                           glm::cross(glm::dvec3(mesh[k + 1].position), glm::dvec3(mesh[k + 2].position))) /
                  6;
    }
    for (const auto& [edge, count] : edges)
        if (edges[std::pair(edge.second, edge.first)] != count)
            return 0;
    return volume;
}

void GlMeshesTest::fixturesAreClosedAndToScale() {
    const Vec3 origin(1000, -500, 20);
    const std::vector<SolidVertex> box = fixtureMesh({{"a", FixtureBox{1003, -490, 15, 20, 30, 40}}}, origin);
    QVERIFY(std::abs(volumeOf(box) - 20.0 * 30 * 40) < 0.1);
    Box3 extent;
    for (const SolidVertex& vertex : box)
        extent.add(Vec3(vertex.position));
    QVERIFY(extent.lo == Vec3(3, 10, -5) && extent.hi == Vec3(23, 40, 35));
    const double round = volumeOf(fixtureMesh({{"a", FixtureCylinder{1000, -500, 20, 20, 40}}}, origin));
    QVERIFY(std::abs(round / (100 * std::numbers::pi * 40) - 1) < 0.005);
    // A mesh is turned by a quarter, so that (20, 0, 0) comes to (0, 20, 0), and scaled.
    const std::vector<FixtureFacet> facets{{glm::vec3(0), glm::vec3(10, 0, 0), glm::vec3(0, 10, 0)}};
    const FixtureMesh mesh{.x = 1000,
                           .y = -500,
                           .z = 20,
                           .turn = 90,
                           .scale = 2,
                           .surface = std::make_shared<const FixtureSurface>(facets)};
    const std::vector<SolidVertex> facet = fixtureMesh({{"a", mesh}, {"b", FixtureMesh{}}}, origin);
    QCOMPARE(facet.size(), std::size_t{3});
    const glm::vec3 zero = glm::vec3(Vec3(1000, -500, 20) - origin);
    QVERIFY(glm::distance(facet[1].position, zero + glm::vec3(0, 20, 0)) < 1e-4F);
    QVERIFY(glm::distance(facet[2].position, zero + glm::vec3(-20, 0, 0)) < 1e-4F);
    QVERIFY(glm::distance(facet[0].normal, glm::vec3(0, 0, 1)) < 1e-6F);
    // Each fixture has its number, in the order of the names; the normals face outwards.
    const Fixtures two{{"b", FixtureBox{0, 0, 0, 1, 1, 1}}, {"a", FixtureCylinder{5, 5, 0, 2, 3}}};
    for (const SolidVertex& vertex : fixtureMesh(two, Vec3(0))) {
        const glm::vec3 middle = vertex.part < 0.5f ? glm::vec3(5, 5, 1.5) : glm::vec3(0.5);
        QVERIFY(glm::dot(vertex.position - middle, vertex.normal) > 0);
    }
    const Box3 around = boundsOf(two.at("a"));
    QVERIFY(around.lo == Vec3(4, 4, 0) && around.hi == Vec3(6, 6, 3));
}

/// Checks top, walls and underside together: every edge has an opposite edge.
static void isClosed(const SurfaceSnapshot& surface) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        ++edges[{a, b}];
        ++edges[{b, c}];
        ++edges[{c, a}];
    };
    for (const LatticeTriangle& triangle : surface.triangles())
        add(triangle[0], triangle[1], triangle[2]);
    for (const WallLine& line : wallLines(surface)) {
        const WallMesh mesh = wallMesh(surface.grid, line);
        for (const auto& face : {mesh.wall, mesh.underside})
            for (std::size_t k = 0; k < face.size(); k += 3)
                add(face[k], face[k + 1], face[k + 2]);
    }
    for (const auto& [edge, count] : edges) {
        QCOMPARE(count, 1);
        QCOMPARE((edges.contains({edge.second, edge.first})), true);
    }
}

void GlMeshesTest::wallsCloseTheSurface() {
    DecimationParameters parameters;
    parameters.regionCells = 8;
    FrameBuilder builder({{0, 0, 0}, 33, 21, 10}, 1, parameters);
    builder.cutAll([](double x, double y) { return -3 + std::sin(x * 0.3) + std::cos(y * 0.5); });
    builder.decimate();
    builder.cut({0, 0, 12, 9}, [](double x, double) { return -5 - 0.1 * x; });
    const FramePtr frame = builder.frame();
    QVERIFY(frame->surface.dirtyRegions > 0 && frame->surface.dirtyRegions < frame->surface.meshes.size());
    isClosed(frame->surface);
}

void GlMeshesTest::wallsCloseMergedRegions() {
    // Merged meshes omit points of the borders, also at the edge of the stock.
    DecimationParameters parameters;
    parameters.regionCells = 8;
    FrameBuilder builder({{0, 0, 0}, 133, 70, 10}, 1, parameters);
    for (const double bend : {0.0, 0.02, 0.3}) {
        builder.cutAll(
            [=](double x, double y) { return -3 - bend + std::sin(x * bend) + std::cos(y * bend); });
        const FramePtr frame = builder.frame();
        RefinedSurface refined(builder.grid().nx, builder.grid().ny, parameters);
        QVERIFY(refined.follow(frame->zmap, {}));
        isClosed(refined.snapshot());
    }
}

void GlMeshesTest::pathFollowsTheMotions() {
    Program program;
    Motion feed;
    feed.kind = MotionKind::feed;
    feed.startKnown = feed.endKnown = kAllAxes;
    feed.end = {10, 0, 0};
    Motion arc = feed;
    arc.kind = MotionKind::arc;
    arc.start = feed.end;
    arc.centre = {10, 5, 0};
    arc.end = {10, 10, 0};
    arc.sweep = std::numbers::pi;
    Motion unknown = feed;
    unknown.endKnown = kAxisX;
    for (const Motion& motion : {feed, arc, unknown}) {
        program.beginBlock(1);
        program.append(motion);
    }
    const PathLines lines = pathLines(program, 0, 99);
    QCOMPARE(lines.blockFirst.size(), std::size_t{4});
    QCOMPARE(lines.verticesBefore(0), std::size_t{0});
    QCOMPARE(lines.verticesBefore(1), std::size_t{2});
    QCOMPARE(lines.verticesBefore(3), lines.vertices.size()); // unknown motions are not drawn
    for (std::size_t k = 2; k < lines.vertices.size(); ++k) {
        const Vec3 at = lines.origin + Vec3(lines.vertices[k].position);
        QVERIFY(std::abs(glm::distance(at, arc.centre) - 5) < 0.001);
        if (k % 2 == 1) {
            const Vec3 middle = lines.origin + 0.5 * (Vec3(lines.vertices[k - 1].position) +
                                                      Vec3(lines.vertices[k].position));
            QVERIFY(glm::distance(middle, arc.centre) > 5 - 0.021);
        }
    }
    const PathLines later = pathLines(program, 1, 2);
    QCOMPARE(later.verticesBefore(1), std::size_t{0});
    QCOMPARE(later.verticesBefore(2), later.vertices.size());
}

void GlMeshesTest::overviewStaysNearThePath() {
    // Rows of short motions over hills, separated by rapids.
    constexpr int kRows = 60;
    constexpr int kSteps = 400;
    auto program = std::make_shared<Program>();
    Vec3 at(-5, 0, 10);
    std::vector<Vec3> ends;
    const auto go = [&](MotionKind kind, const Vec3& to) {
        Motion motion;
        motion.kind = kind;
        motion.startKnown = motion.endKnown = kAllAxes;
        motion.start = at;
        motion.end = at = to;
        program->beginBlock(1);
        program->append(motion);
        ends.push_back(to);
    };
    for (int row = 0; row < kRows; ++row) {
        go(MotionKind::rapid, {0, row, 10});
        for (int k = 0; k <= kSteps; ++k) {
            const double x = 0.25 * k;
            go(MotionKind::feed, {x, row, -3 + std::sin(0.2 * x) * std::cos(0.3 * row)});
        }
        go(MotionKind::rapid, {at.x, row, 10});
    }
    program->settle();
    PathOverview overview;
    QVERIFY(overview.setProgram(program));
    QVERIFY(!overview.setProgram(program));
    int calls = 0;
    for (; !overview.whole(); ++calls)
        overview.advance(UploadBudget(std::chrono::seconds(0)));
    QVERIFY(calls > 10); // several parts
    const std::vector<PathVertex>& vertices = overview.vertices();
    QVERIFY2(vertices.size() / 2 < program->blockCount() / 5, qPrintable(QString::number(vertices.size())));
    QCOMPARE(overview.verticesBefore(0), std::size_t{0});
    QCOMPARE(overview.verticesBefore(program->blockCount()), vertices.size());
    // Every end is on the line that contains its block, which may start a few blocks earlier.
    for (std::size_t block = 0; block < ends.size(); block += 7) {
        const std::size_t until = overview.verticesBefore(block + 1);
        double nearest = 1e9;
        for (std::size_t k = until >= 4 ? until - 4 : 0; k < until; k += 2) {
            const Vec3 a = overview.origin() + Vec3(vertices[k].position);
            const Vec3 b = overview.origin() + Vec3(vertices[k + 1].position);
            const double t = std::clamp(glm::dot(ends[block] - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
            nearest = std::min(nearest, glm::distance(ends[block], a + (b - a) * t));
        }
        QVERIFY2(nearest < overview.tolerance() + 1e-4, qPrintable(QString::number(nearest)));
    }
}

namespace {

/// Blocks with the given number of motions each, alternating up and down; or arcs with many turns.
std::shared_ptr<const Program> manyMotions(int blocks, int motionsOfBlock, bool arcs) {
    auto program = std::make_shared<Program>();
    Motion motion;
    motion.startKnown = motion.endKnown = kAllAxes;
    for (int block = 0; block < blocks; ++block) {
        program->beginBlock(1);
        for (int k = 0; k < motionsOfBlock; ++k) {
            motion.start = motion.end;
            motion.kind = k % 2 == 0 ? MotionKind::feed : MotionKind::rapid;
            motion.end = Vec3(0.001 * (block + k), 0, k % 2 == 0 ? -5 : 5);
            if (arcs) {
                motion.kind = MotionKind::arc;
                motion.end = motion.start;
                motion.centre = motion.start + Vec3(50, 0, 0);
                motion.sweep = 900 * std::numbers::pi;
            }
            program->append(motion);
        }
    }
    program->settle();
    return program;
}

} // namespace

void GlMeshesTest::pathIsCoarserWhereItIsManyLines() {
    const auto program = manyMotions(20'000, 1, true);
    const PathLines lines = pathLines(*program, 0, program->blockCount());
    QVERIFY2(lines.vertices.size() <= 2 * kMostPathLines, qPrintable(QString::number(lines.vertices.size())));
    QCOMPARE(lines.verticesBefore(program->blockCount()), lines.vertices.size());
    QVERIFY(pathLines(*program, 0, 1).vertices.size() > lines.vertices.size() / program->blockCount());
}

void GlMeshesTest::pathOfAFrameHasFewMotions() {
    const auto deep = manyMotions(300, 10'000, false);
    const BlockRange range = blocksForFrame(*deep, 150, {70, 300});
    QVERIFY(range.first > 70 && range.first < 150 && range.last > 150 && range.last < 300);
    const auto motions = 10'000 * (range.last - range.first);
    QVERIFY2(motions <= kMostPathLines, qPrintable(QString::number(motions)));
    const auto flat = manyMotions(300, 2, false);
    const BlockRange all = blocksForFrame(*flat, 150, {70, 300});
    QVERIFY(all.first == 70 && all.last == 300);
    const BlockRange end = blocksForFrame(*flat, 300, {220, 300});
    QVERIFY(end.first == 220 && end.last == 300);
}

/// No tolerance can simplify a path that goes up and down many times.
void GlMeshesTest::overviewOfManyMotionsEnds() {
    const auto program = manyMotions(4, 100'000, false);
    PathOverview overview;
    QVERIFY(overview.setProgram(program));
    int calls = 0;
    for (; !overview.whole() && calls < 1'000'000; ++calls)
        overview.advance(UploadBudget(std::chrono::seconds(0)));
    QVERIFY(overview.whole());
    QVERIFY(calls > 100); // a block is processed in parts
    QVERIFY(overview.vertices().size() <= 2 * PathOverview::kMostLines);
}

QTEST_APPLESS_MAIN(GlMeshesTest)
#include "gl_meshes_test.moc"
