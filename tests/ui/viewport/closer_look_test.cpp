// SPDX-License-Identifier: GPL-3.0-or-later
// Compares a detail region with a direct simulation, and checks that it is never shown for another moment.
#include <chrono>
#include <cmath>
#include <memory>
#include <stop_token>
#include <string>
#include <thread>

#include <QTest>

#include "core/nc/run/interpreter.h"
#include "core/simulation/run/simulation.h"
#include "ui/viewport/box_choice.h"
#include "ui/viewport/closer_look.h"

using namespace proveout;

namespace {

constexpr int kPatience = 30'000; // ms
constexpr double kPlenty = 4e9;   // bytes
constexpr double kFine = 0.05;    // mm
const PlanBox kBox{{4, 4}, {9, 11}};
/// More points than can be cut and decimated before a test changes the request.
const BoxOfInterest kMuchWork{{{1, 1}, {19, 19}}, 0.01};

std::shared_ptr<const Setup> setup() {
    auto setup = std::make_shared<Setup>();
    setup->stock = {{0, 0, 0}, 20, 20, 5};
    setup->spacing = 1;
    setup->tools.set(1, parseCutter("ball:d=4,l=20").value());
    return setup;
}

std::shared_ptr<const Program> program() {
    static const NcText kText("G21 G90 T1 M6\nG0 X-5 Y5 Z5\nG0 Z-1\nG1 X25 F500\nG1 Y7.3 Z-1.5\nG1 X-5\n");
    return interpret(kText);
}

FramePtr frameAt(const std::shared_ptr<const Program>& program, const std::shared_ptr<const Setup>& setup,
                 std::size_t block) {
    auto frame = std::make_shared<Frame>();
    frame->program = program;
    frame->setup = setup;
    frame->block = block;
    return frame;
}

/// Lets a task start and finish without delivering its result to the event loop.
void letItFinishUnheard(const CloserLook& look) {
    QCoreApplication::processEvents(); // once: a result that is there sooner would be heard later
    QVERIFY(look.working());
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
}

} // namespace

class CloserLookTest : public QObject {
    Q_OBJECT

private slots:
    void init();
    void equalsTheWholeStockOnThatGrid();
    void showsWallsWhereTheyStand();
    void showsTheMomentThatIsFollowed();
    void dropsWhatWasCutForAnotherMoment();
    void anotherProgramOrSetupIsAnotherMoment();
    void cancelLeavesNothing();
    void closeLeavesNothing();
    void refusesWithASpacingThatFits();
    void aStoppedBoxIsNothing();
    void clicksAndDragsMakeBoxesWithinTheStock();

private:
    std::shared_ptr<const Setup> m_setup;
    std::shared_ptr<const Program> m_program;
    FramePtr m_first;
    FramePtr m_last;
};

void CloserLookTest::init() {
    m_setup = setup();
    m_program = program();
    QVERIFY(m_program->blockCount() >= 4);
    m_first = frameAt(m_program, m_setup, m_program->blockCount() - 1);
    m_last = frameAt(m_program, m_setup, m_program->blockCount());
}

void CloserLookTest::equalsTheWholeStockOnThatGrid() {
    auto fine = std::make_shared<Setup>(*m_setup);
    fine->spacing = kFine;
    DecimationParameters undecimated;
    undecimated.method = DecimationMethod::none;
    const auto whole = std::move(Simulation::create(m_program, fine, undecimated).value());
    whole->seek(m_last->block);
    const ZMapSnapshot expected = whole->zmap();
    const FramePtr box = closerFrame(*m_last, {kBox, kFine}, {}, kPlenty).value();
    const Grid& grid = box->zmap.grid();
    QCOMPARE(grid.nx, 101);
    QCOMPARE(grid.ny, 141);
    int cut = 0;
    for (int j = 0; j < grid.ny; ++j)
        for (int i = 0; i < grid.nx; ++i) {
            QCOMPARE(box->zmap.height(i, j), expected.height(i + 80, j + 80));
            cut += box->zmap.height(i, j) < 0 ? 1 : 0;
        }
    QVERIFY(cut > 1000 && cut < grid.nx * grid.ny);
    QVERIFY(box->surface.faces > 0 && box->surface.faces < box->surface.facesFull);
    QCOMPARE(box->surface.dirtyRegions, std::size_t{0});
}

void CloserLookTest::showsWallsWhereTheyStand() {
    auto flat = std::make_shared<Setup>(*m_setup);
    flat->tools.set(1, parseCutter("flat:d=4.06").value());
    const auto frame = frameAt(m_program, flat, 4); // a slot along Y5, at 1 mm
    const FramePtr box = closerFrame(*frame, {{{4, 4}, {9, 9}}, kFine}, {}, kPlenty).value();
    QVERIFY(box->zmap.walls().count() > 100);
    const WallPoint* wall = box->zmap.walls().find(50, 60); // at Y7, beside the wall at Y7.03
    QVERIFY(wall != nullptr);
    QVERIFY(wall->isUpright);
    QVERIFY(std::abs(vertexAt(box->zmap, 50, 60).y - 7.03) < 1e-4);
}

void CloserLookTest::showsTheMomentThatIsFollowed() {
    CloserLook look;
    FramePtr followed = m_first;
    connect(&look, &CloserLook::changed, this, [&] {
        if (const FramePtr picture = look.picture())
            QCOMPARE(picture->block, followed->block);
    });
    look.follow(m_first);
    QVERIFY(!look.working());
    look.look({kBox, kFine});
    QVERIFY(look.working() && look.picture() == nullptr);
    QTRY_VERIFY_WITH_TIMEOUT(look.picture() != nullptr, kPatience);
    QVERIFY(!look.working());
    QVERIFY(look.status().contains(QStringLiteral("101 × 141")));
    QVERIFY(look.status().contains(QStringLiteral("0.05 mm")));
    const FramePtr first = look.picture();
    followed = m_last;
    look.follow(m_last);
    QVERIFY(look.picture() == nullptr);
    QTRY_VERIFY_WITH_TIMEOUT(look.picture() != nullptr, kPatience);
    bool unlike = false;
    for (int i = 0; i < first->zmap.grid().nx; ++i)
        unlike = unlike || first->zmap.height(i, 70) != look.picture()->zmap.height(i, 70);
    QVERIFY(unlike);
    // The same moment in a newer frame, and back before anything else is cut.
    const FramePtr last = look.picture();
    look.follow(frameAt(m_program, m_setup, m_last->block));
    QCOMPARE(look.picture(), last);
    followed = m_first;
    look.follow(m_first);
    QVERIFY(look.picture() == nullptr && look.working());
    followed = m_last;
    look.follow(m_last);
    QVERIFY(look.picture() == last && !look.working());
}

void CloserLookTest::dropsWhatWasCutForAnotherMoment() {
    CloserLook look;
    look.follow(m_first);
    look.look({kBox, kFine});
    letItFinishUnheard(look);
    look.follow(m_last);
    QVERIFY(look.picture() == nullptr);
    QTRY_VERIFY_WITH_TIMEOUT(!look.working(), kPatience);
    QCOMPARE(look.picture()->block, m_last->block);
    // The same while it is running.
    look.look(kMuchWork);
    QTest::qWait(10);
    look.follow(m_first);
    look.look({kBox, kFine});
    QTRY_VERIFY_WITH_TIMEOUT(!look.working(), kPatience);
    QCOMPARE(look.picture()->block, m_first->block);
    QCOMPARE(look.picture()->zmap.grid().nx, 101);
}

void CloserLookTest::anotherProgramOrSetupIsAnotherMoment() {
    CloserLook look;
    look.follow(m_last);
    look.look({kBox, kFine});
    QTRY_VERIFY_WITH_TIMEOUT(look.picture() != nullptr, kPatience);
    look.follow(frameAt(program(), m_setup, m_last->block));
    QVERIFY(look.picture() == nullptr);
    QTRY_VERIFY_WITH_TIMEOUT(look.picture() != nullptr, kPatience);
    look.follow(frameAt(look.picture()->program, setup(), m_last->block));
    QVERIFY(look.picture() == nullptr);
    QTRY_VERIFY_WITH_TIMEOUT(look.picture() != nullptr, kPatience);
    look.follow(nullptr);
    QVERIFY(look.picture() == nullptr && !look.working());
}

void CloserLookTest::cancelLeavesNothing() {
    CloserLook look;
    look.follow(m_last);
    look.look({kBox, kFine});
    letItFinishUnheard(look);
    look.cancel();
    QVERIFY(!look.working());
    QTest::qWait(50);
    QVERIFY(look.picture() == nullptr);
    QVERIFY(look.box().has_value());
    QVERIFY(look.status().contains(QStringLiteral("cancelled")));
    QVERIFY(look.isLeft());
    look.again();
    QVERIFY(look.working() && !look.isLeft());
    QTRY_VERIFY_WITH_TIMEOUT(look.picture() != nullptr, kPatience);
    QCOMPARE(look.picture()->block, m_last->block);
    const FramePtr picture = look.picture();
    look.again(); // there is nothing to do
    QVERIFY(!look.working() && look.picture() == picture);
    look.follow(m_first);
    look.cancel();
    look.follow(m_last); // back before anything else is cut
    QVERIFY(look.picture() == picture && !look.isLeft());
    look.follow(m_first);
    QTRY_VERIFY_WITH_TIMEOUT(look.picture() != nullptr, kPatience);
}

void CloserLookTest::closeLeavesNothing() {
    CloserLook look;
    look.follow(m_last);
    look.look({kBox, kFine});
    letItFinishUnheard(look);
    look.close();
    look.follow(m_first);
    QTest::qWait(300);
    QVERIFY(look.picture() == nullptr && !look.working() && !look.box());
}

void CloserLookTest::refusesWithASpacingThatFits() {
    constexpr double kLittle = 2e5; // bytes
    const auto refused = closerFrame(*m_last, {kBox, kFine / 10}, {}, kLittle);
    QVERIFY(!refused.has_value());
    QCOMPARE(refused.error().front().id, std::string("box-needs-too-much-memory"));
    const double fits = std::stod(refused.error().front().arguments.back());
    QVERIFY(fits > kFine / 10);
    QVERIFY(closerFrame(*m_last, {kBox, fits}, {}, kLittle).has_value());
    CloserLook look;
    look.follow(m_last);
    look.look({{{0, 0}, {20, 20}}, 1e-4});
    QTRY_VERIFY_WITH_TIMEOUT(!look.working(), kPatience);
    QVERIFY(look.picture() == nullptr);
    QVERIFY2(look.status().contains(QStringLiteral("the finest possible is")), qPrintable(look.status()));
    look.look({kBox, kFine});
    QTRY_VERIFY_WITH_TIMEOUT(look.picture() != nullptr, kPatience);
}

void CloserLookTest::aStoppedBoxIsNothing() {
    std::stop_source stop;
    WorkContext context{stop.get_token(), {}};
    context.progress = [&](double) { stop.request_stop(); };
    const auto stopped = closerFrame(*m_last, kMuchWork, context, kPlenty);
    QVERIFY(stopped.has_value() && *stopped == nullptr);
}

void CloserLookTest::clicksAndDragsMakeBoxesWithinTheStock() {
    const StockBox stock{{-10, 0, 0}, 40, 30, 10};
    const auto down = [](double x, double y) { return Ray{{x, y, 50}, {0, 0, -1}}; };
    BoxChoice click(Vec3(0, 10, -2), {100, 100});
    click.dragTo({103, 100}, down(1, 10));
    QCOMPARE(click.box(stock, {4, 6}), (PlanBox{{-2, 7}, {2, 13}}));
    BoxChoice atTheRim(Vec3(29.5, 0.5, 0), {100, 100});
    QCOMPARE(atTheRim.box(stock, {4, 6}), (PlanBox{{26, 0}, {30, 6}}));
    QCOMPARE(atTheRim.box(stock, {400, 600}), (PlanBox{{-10, 0}, {30, 30}}));
    BoxChoice drag(Vec3(5, 20, -2), {100, 100});
    drag.dragTo({200, 200}, down(-3, 4));
    QCOMPARE(drag.box(stock, {4, 6}), (PlanBox{{-3, 4}, {5, 20}}));
    drag.dragTo({400, 400}, down(-300, 100));
    QCOMPARE(drag.box(stock, {4, 6}), (PlanBox{{-10, 20}, {5, 30}}));
    // Along an axis the box still has a visible size.
    drag.dragTo({100, 300}, down(15, 20));
    const PlanBox flat = drag.box(stock, {4, 6});
    QVERIFY(std::abs(flat.hi.y - flat.lo.y - kLeastBoxSide) < 1e-9);
}

QTEST_MAIN(CloserLookTest)
#include "closer_look_test.moc"
