// SPDX-License-Identifier: GPL-3.0-or-later
// When the block under the pointer is searched, and when not.
#include "ui/readout/surface_probe.h"

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

#include <QSignalSpy>
#include <QTest>

#include "core/nc/run/interpreter.h"
#include "core/simulation/run/simulation.h"
#include "ui/readout/probe_text.h"

namespace proveout {
namespace {

constexpr int kPatience = 10'000; // ms
constexpr int kLongRest = 3 * SurfaceProbe::kRestMilliseconds;

std::shared_ptr<const Setup> setup() {
    auto setup = std::make_shared<Setup>();
    setup->stock = {{0, 0, 0}, 20, 20, 5};
    setup->spacing = 1;
    setup->tools.set(1, parseCutter("flat:d=4,l=20").value());
    return setup;
}

FramePtr frameAfter(const Simulation& simulation, const std::shared_ptr<const Program>& program,
                    const std::shared_ptr<const Setup>& setup) {
    auto frame = std::make_shared<Frame>();
    frame->program = program;
    frame->setup = setup;
    frame->block = simulation.position();
    frame->zmap = simulation.zmap();
    return frame;
}

} // namespace

class SurfaceProbeTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_setup = setup();
        // Along Y5, 1 mm deep; then along Y15, then along Y5 again, 1 mm deeper; finally in G55.
        m_program = interpret(NcText("G21 G90 T1 M6\nG10 L2 P2 X3 Y4 Z-2\nG0 X-5 Y5 Z5\nG0 Z-1\nG1 X25 F500\n"
                                     "G0 Y15\nG1 X-5\nG55 G0 Y1\nG1 Z0\nX30\nM2\n"));
        const auto simulation = std::move(Simulation::create(m_program, m_setup, {}).value());
        m_frames.push_back(frameAfter(*simulation, m_program, m_setup));
        while (simulation->position() < m_program->blockCount()) {
            simulation->step();
            m_frames.push_back(frameAfter(*simulation, m_program, m_setup));
        }
    }

    void showsTheBlockOncePointerRests() {
        SurfaceProbe probe;
        QSignalSpy answered(&probe, &SurfaceProbe::answered);
        probe.point(at(3, {10, 5}));
        QVERIFY(!probe.answer());
        QTRY_VERIFY_WITH_TIMEOUT(probe.answer().has_value(), kPatience);
        QCOMPARE(probe.answer()->kind, PlaceAnswer::Kind::cut);
        QCOMPARE(probe.answer()->line, 5U);
        QCOMPARE(probe.answer()->tool, 1);
        QCOMPARE(answered.count(), 1);
        probe.point(at(3, {10, 12}));
        QTRY_VERIFY_WITH_TIMEOUT(probe.answer().has_value(), kPatience);
        QCOMPARE(probe.answer()->kind, PlaceAnswer::Kind::neverCut);
        probe.point(onTheSide(3));
        QVERIFY(probe.answer() && probe.answer()->kind == PlaceAnswer::Kind::neverCut);
        probe.point(std::nullopt);
        QVERIFY(!probe.place() && !probe.answer());
    }

    /// Cut with an assumed tool, and named as such.
    void namesTheToolThatIsAssumed() {
        const auto program = interpret(NcText("G21 G90\nG0 X-5 Y5 Z5\nG0 Z-1\nG1 X25 F500\nM2\n"));
        const auto simulation = std::move(Simulation::create(program, m_setup, {}).value());
        simulation->seek(program->blockCount());
        SurfaceProbe probe;
        probe.point(
            SurfacePlace{{frameAfter(*simulation, program, m_setup), MapPoint{10, 5}}, Vec3(10, 5, -1)});
        QTRY_VERIFY_WITH_TIMEOUT(probe.answer().has_value(), kPatience);
        QCOMPARE(cutText(probe), QStringLiteral("Line 4, T1 (assumed)"));
    }

    void asksOnlyWhereItRests() {
        std::atomic<int> asked = 0;
        SurfaceProbe probe(nullptr, [&](const Frame&, const MapPoint& point, const WorkContext&) {
            ++asked;
            return std::optional<std::size_t>(static_cast<std::size_t>(point.i % 2));
        });
        for (int i = 2; i < 18; ++i) {
            probe.point(at(4, {i, 5}));
            QTest::qWait(SurfaceProbe::kRestMilliseconds / 10);
        }
        QTRY_VERIFY_WITH_TIMEOUT(probe.answer().has_value(), kPatience);
        QVERIFY2(asked <= 2, qPrintable(QString::number(asked))); // once, except on a slow machine
        // Another program is in the editor: nothing is searched, and no lines are shown.
        const int before = asked;
        probe.point(at(4, {3, 5}), false);
        QTest::qWait(kLongRest);
        QCOMPARE(asked.load(), before);
        QVERIFY(probe.place() && !probe.answer());
    }

    void stopsTheSearchWhenThePointerMovesOn() {
        std::atomic<bool> searching = false;
        std::atomic<bool> stopped = false;
        SurfaceProbe probe(nullptr, [&](const Frame&, const MapPoint&, const WorkContext& context) {
            searching = true;
            while (!context.stopped())
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            stopped = true;
            return std::optional<std::size_t>();
        });
        QSignalSpy answered(&probe, &SurfaceProbe::answered);
        probe.point(at(4, {10, 5}));
        QTRY_VERIFY_WITH_TIMEOUT(searching.load(), kPatience);
        probe.point(at(4, {11, 5}));
        QTRY_VERIFY_WITH_TIMEOUT(stopped.load(), kPatience);
        QCOMPARE(answered.count(), 0);
        probe.point(std::nullopt);
    }

    void keepsTheAnswerWhileOtherPlacesAreCut() {
        std::atomic<int> asked = 0;
        SurfaceProbe probe(nullptr,
                           [&](const Frame& moment, const MapPoint& point, const WorkContext& context) {
                               ++asked;
                               return blockThatMade(moment, point, context);
                           });
        probe.point(at(3, {10, 5}));
        QTRY_VERIFY_WITH_TIMEOUT(probe.answer().has_value(), kPatience);
        for (std::size_t block = 4; block < m_frames.size() - 1; ++block) {
            probe.point(at(block, {10, 5}));
            QVERIFY(probe.answer() && probe.answer()->line == 5U);
        }
        QTest::qWait(kLongRest);
        QCOMPARE(asked.load(), 1);
        probe.point(at(2, {10, 5})); // back to before it was cut
        QTRY_VERIFY_WITH_TIMEOUT(probe.answer().has_value(), kPatience);
        QCOMPARE(probe.answer()->kind, PlaceAnswer::Kind::neverCut);
        QCOMPARE(asked.load(), 2);
    }

    void countsFromTheActiveWorkOffset() {
        SurfaceProbe probe;
        probe.point(at(3, {10, 5}));
        QCOMPARE(probe.offset().code, std::string("G54"));
        QCOMPARE(probe.workPosition(), Vec3(10, 5, -1));
        probe.point(at(m_frames.size() - 1, {10, 5}));
        QCOMPARE(probe.offset().code, std::string("G55"));
        QCOMPARE(probe.workPosition(), Vec3(7, 1, 0));
    }

private:
    [[nodiscard]] SurfacePlace at(std::size_t block, const MapPoint& point) const {
        const FramePtr& frame = m_frames.at(block);
        return {{frame, point}, Vec3(point.i, point.j, double{frame->zmap.height(point.i, point.j)})};
    }
    [[nodiscard]] SurfacePlace onTheSide(std::size_t block) const {
        return {{m_frames.at(block), std::nullopt}, Vec3(0, 0, -2)};
    }

    std::shared_ptr<const Setup> m_setup;
    std::shared_ptr<const Program> m_program;
    std::vector<FramePtr> m_frames;
};

} // namespace proveout

QTEST_MAIN(proveout::SurfaceProbeTest)
#include "surface_probe_test.moc"
