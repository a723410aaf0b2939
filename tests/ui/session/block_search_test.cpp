// SPDX-License-Identifier: GPL-3.0-or-later
// From a position on the stock to its block: only the newest request counts, only for the current moment; and
// the way back.
#include <atomic>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#include <QTest>

#include "core/simulation/run/simulation.h"
#include "tests/ui/opened.h"
#include "ui/program/block_search.h"
#include "ui/session/session.h"

namespace proveout {
namespace {

constexpr int kPatience = 30'000; // ms
const QString kSample = QStringLiteral(PROVEOUT_SOURCE_DIR "/resources/samples/core-insert.proveout");

/// Lets the current work finish without delivering its result to the event loop.
void letItFinishUnheard() {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
}

/// For each point, the block, from 1, that last lowered it noticeably among all executed blocks; 0 if there
/// is none. Found by checking the z-map after each block.
std::vector<std::size_t> lastCuts(const Frame& moment, const std::vector<MapPoint>& points) {
    DecimationParameters undecimated;
    undecimated.method = DecimationMethod::none;
    const auto simulation = std::move(Simulation::create(moment.program, moment.setup, undecimated).value());
    std::vector<std::size_t> blocks(points.size(), 0);
    std::vector<float> heights(points.size(), 0);
    while (simulation->position() < moment.block) {
        simulation->step();
        const ZMapSnapshot zmap = simulation->zmap();
        for (std::size_t k = 0; k < points.size(); ++k) {
            const float height = zmap.height(points[k].i, points[k].j);
            if (height < heights[k] - 0.002F)
                blocks[k] = simulation->position();
            heights[k] = height;
        }
    }
    return blocks;
}

/// The results of a session, and the lines that it requested to show.
struct Reported {
    explicit Reported(Session& session) {
        QObject::connect(&session.navigation(), &NavigationHub::placeFound, &session,
                         [this](const PlaceAnswer& answer) { answers.push_back(answer); });
        QObject::connect(&session.navigation(), &NavigationHub::lineRequested, &session,
                         [this](std::uint32_t line, int) { lines.push_back(line); });
    }
    std::vector<PlaceAnswer> answers;
    std::vector<std::uint32_t> lines;
};

} // namespace

class BlockSearchTest : public QObject {
    Q_OBJECT

private slots:
    void theNewestQuestionCounts() {
        const FramePtr moment = openedAt(100)->simulation().frame();
        std::atomic<int> stopped = 0;
        BlockSearch search(nullptr, [&](const Frame&, const MapPoint& point, const WorkContext& context) {
            while (point.i == 0 && !context.stopped())
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            stopped += context.stopped() ? 1 : 0;
            return std::optional(static_cast<std::size_t>(point.i));
        });
        std::vector<std::size_t> blocks;
        connect(&search, &BlockSearch::answered, this,
                [&](const PlaceAnswer& answer) { blocks.push_back(answer.block); });
        search.ask(moment, {7, 0});
        letItFinishUnheard();
        search.ask(moment, {0, 0});
        QTest::qWait(50);
        search.ask(moment, {3, 0});
        QTRY_VERIFY_WITH_TIMEOUT(!blocks.empty(), kPatience);
        QTest::qWait(50);
        QCOMPARE(blocks, std::vector<std::size_t>{4});
        QCOMPARE(stopped.load(), 1);
    }

    void reportsProgressOfLongWork() {
        const FramePtr moment = openedAt(100)->simulation().frame();
        std::atomic<bool> proceed = false;
        BlockSearch search(nullptr, [&](const Frame&, const MapPoint&, const WorkContext& context) {
            for (int percent = 0; !proceed && !context.stopped(); percent = std::min(percent + 1, 90)) {
                context.report(percent / 100.0);
                std::this_thread::sleep_for(std::chrono::milliseconds(10));
            }
            return std::optional<std::size_t>();
        });
        std::vector<PlaceAnswer> answers;
        connect(&search, &BlockSearch::answered, this,
                [&](const PlaceAnswer& answer) { answers.push_back(answer); });
        search.ask(moment, {1, 1});
        QVERIFY(!search.done());
        QTRY_VERIFY_WITH_TIMEOUT(search.done().value_or(0) > 0.3, kPatience);
        proceed = true;
        QTRY_COMPARE_WITH_TIMEOUT(answers.size(), std::size_t{1}, kPatience);
        QVERIFY(!search.done());
        QCOMPARE(answers.front(), (PlaceAnswer{PlaceAnswer::Kind::neverCut, 100, 0, 0}));
        proceed = false;
        search.ask(moment, {1, 1});
        QTRY_VERIFY_WITH_TIMEOUT(search.done().has_value(), kPatience);
        search.cancel();
        QVERIFY(!search.done());
        QTest::qWait(300);
        QVERIFY(!search.done());
        QCOMPARE(answers.size(), std::size_t{1});
    }

    void whatIsThrownIsReported() {
        const FramePtr moment = openedAt(10)->simulation().frame();
        BlockSearch search(
            nullptr, [](const Frame&, const MapPoint&, const WorkContext&) -> std::optional<std::size_t> {
                throw std::runtime_error("reason");
            });
        Diagnostics reported;
        connect(&search, &BlockSearch::failed, this, [&](const Diagnostics& errors) { reported = errors; });
        search.ask(moment, {1, 1});
        QTRY_COMPARE_WITH_TIMEOUT(reported.size(), std::size_t{1}, kPatience);
        QCOMPARE(reported.front().arguments.front(), std::string("reason"));
    }

    void goesToTheBlockThatCutThePlaceLast_data() {
        QTest::addColumn<int>("block");
        QTest::newRow("while it is faced") << 15;
        QTest::newRow("in the pocket") << 200;
    }

    void goesToTheBlockThatCutThePlaceLast() {
        QFETCH(int, block);
        const auto session = openedAt(static_cast<std::size_t>(block));
        const FramePtr moment = session->simulation().frame();
        std::vector<MapPoint> points;
        for (int j = 3; j < moment->zmap.grid().ny; j += 23)
            for (int i = 5; i < moment->zmap.grid().nx; i += 23)
                points.push_back({i, j});
        const std::vector<std::size_t> expected = lastCuts(*moment, points);
        Reported reported(*session);
        std::size_t cut = 0;
        for (std::size_t k = 0; k < points.size(); ++k) {
            session->navigation().goToBlockThatMade({moment, points[k]});
            QTRY_COMPARE_WITH_TIMEOUT(reported.answers.size(), k + 1, kPatience);
            const PlaceAnswer& answer = reported.answers.back();
            QCOMPARE(answer.kind == PlaceAnswer::Kind::cut, expected[k] != 0);
            QCOMPARE(answer.block, expected[k] == 0 ? moment->block : expected[k]);
            if (expected[k] == 0)
                continue;
            ++cut;
            QCOMPARE(answer.line, moment->program->blockLine(expected[k] - 1));
            QCOMPARE(answer.tool, 1);
            QCOMPARE(reported.lines.size(), cut);
            QCOMPARE(reported.lines.back(), answer.line);
            QTRY_COMPARE_WITH_TIMEOUT(session->simulation().block(), expected[k], kPatience);
        }
        QVERIFY(cut > 5);
        QCOMPARE(cut < points.size(), block == 15); // later the whole top is faced
    }

    void leadsBackAsOftenAsAway() {
        const auto session = openedAt(200);
        const FramePtr moment = session->simulation().frame();
        Reported reported(*session);
        QVERIFY(!session->navigation().canReturn());
        const std::size_t first = jump(*session, reported, moment, cutPlace(*moment, 0));
        const std::size_t second = jump(*session, reported, moment, cutPlace(*moment, first));
        QVERIFY(first != second && first < 200);
        session->navigation().returnFromJump();
        QTRY_COMPARE_WITH_TIMEOUT(session->simulation().block(), first, kPatience);
        session->navigation().returnFromJump();
        QTRY_COMPARE_WITH_TIMEOUT(session->simulation().block(), std::size_t{200}, kPatience);
        QVERIFY(!session->navigation().canReturn());
        jump(*session, reported, moment, cutPlace(*moment, 0));
        QVERIFY(session->navigation().canReturn());
        session->document().applyEdit(0, 0, "\n"); // changes its blocks
        QTRY_VERIFY_WITH_TIMEOUT(!session->navigation().canReturn(), kPatience);
    }

    void dropsWhatWasAskedOfAnotherMoment() {
        const auto session = openedAt(200);
        const FramePtr moment = session->simulation().frame();
        const MapPoint point = cutPlace(*moment, 0);
        Reported reported(*session);
        const auto asked = [&] {
            session->navigation().goToBlockThatMade({moment, point});
            letItFinishUnheard();
        };
        asked();
        session->playback().seek(150);
        QTRY_COMPARE_WITH_TIMEOUT(session->simulation().block(), std::size_t{150}, kPatience);
        asked();
        session->playback().step(1);
        QTRY_COMPARE_WITH_TIMEOUT(session->simulation().block(), std::size_t{151}, kPatience);
        asked();
        Setup setup = session->job().setup();
        setup.stock.height += 1;
        QVERIFY(session->job().setSetup(setup));
        QTRY_VERIFY_WITH_TIMEOUT(session->simulation().frame()->setup != moment->setup, kPatience);
        QVERIFY(reported.answers.empty() && reported.lines.empty());
        // For an old moment the result says so, and a request for the new one works.
        session->navigation().goToBlockThatMade({moment, point});
        QCOMPARE(reported.answers.size(), std::size_t{1});
        QCOMPARE(reported.answers.back().kind, PlaceAnswer::Kind::outdated);
        session->playback().seek(200);
        QTRY_COMPARE_WITH_TIMEOUT(session->simulation().block(), std::size_t{200}, kPatience);
        session->navigation().goToBlockThatMade({session->simulation().frame(), point});
        QTRY_COMPARE_WITH_TIMEOUT(reported.answers.size(), std::size_t{2}, kPatience);
        QCOMPARE(reported.answers.back().kind, PlaceAnswer::Kind::cut);
    }

    void anEditMakesItVoidBeforeItIsRead() {
        const auto session = openedAt(200);
        const FramePtr moment = session->simulation().frame();
        const MapPoint point = cutPlace(*moment, 0);
        Reported reported(*session);
        session->navigation().goToBlockThatMade({moment, point});
        letItFinishUnheard();
        session->document().applyEdit(0, 0, "\n");
        // Its lines no longer match the text.
        session->navigation().goToBlockThatMade({moment, point});
        QCOMPARE(reported.answers.size(), std::size_t{1});
        QCOMPARE(reported.answers.back().kind, PlaceAnswer::Kind::outdated);
        QTRY_VERIFY_WITH_TIMEOUT(session->simulation().frame()->program != moment->program &&
                                     session->simulation().frame()->program == session->program().current(),
                                 kPatience);
        QCOMPARE(reported.answers.size(), std::size_t{1});
        QVERIFY(reported.lines.empty());
    }

    void saysWhereNothingWasCutOrNothingIs() {
        const auto session = openedAt(200);
        Reported reported(*session);
        session->navigation().goToBlockThatMade({});
        session->navigation().goToBlockThatMade({session->simulation().frame(), std::nullopt});
        QCOMPARE(reported.answers, (std::vector<PlaceAnswer>{{PlaceAnswer::Kind::noStock, 200, 0, 0},
                                                             {PlaceAnswer::Kind::neverCut, 200, 0, 0}}));
        QVERIFY(reported.lines.empty());
    }

    void aRunIsPaused() {
        const auto session = openedAt(50);
        Reported reported(*session);
        session->playback().setSpeed(20);
        session->playback().play();
        QTRY_VERIFY_WITH_TIMEOUT(session->simulation().block() > 60, kPatience);
        const FramePtr moment = session->simulation().frame();
        session->navigation().goToBlockThatMade({moment, cutPlace(*moment, 0)});
        QVERIFY(!session->playback().state().playing);
        QTRY_COMPARE_WITH_TIMEOUT(reported.answers.size(), std::size_t{1}, kPatience);
        QCOMPARE(reported.answers.back().kind, PlaceAnswer::Kind::cut);
        QTRY_COMPARE_WITH_TIMEOUT(session->simulation().block(), reported.answers.back().block, kPatience);
    }

private:
    static std::unique_ptr<Session> openedAt(std::size_t block) {
        auto session = std::make_unique<Session>();
        if (!opened(*session, kSample) ||
            !QTest::qWaitFor([&] { return session->simulation().frame() != nullptr; }, kPatience))
            qFatal("no frame of the sample");
        session->playback().seek(block);
        if (!QTest::qWaitFor([&] { return session->simulation().block() == block; }, kPatience))
            qFatal("the block is not reached");
        return session;
    }

    /// A point that was cut by a block other than `but`.
    static MapPoint cutPlace(const Frame& moment, std::size_t but) {
        const Grid& grid = moment.zmap.grid();
        for (int j = 0; j < grid.ny; j += 11)
            for (int i = 0; i < grid.nx; i += 11)
                if (const auto block = blockThatMade(moment, {i, j}); block && *block + 1 != but)
                    return {i, j};
        qFatal("nothing is cut");
        return {};
    }

    static std::size_t jump(Session& session, const Reported& reported, const FramePtr& moment,
                            const MapPoint& point) {
        const std::size_t before = reported.answers.size();
        session.navigation().goToBlockThatMade({moment, point});
        const auto there = [&] {
            return reported.answers.size() > before &&
                   session.simulation().block() == reported.answers.back().block;
        };
        if (!QTest::qWaitFor(there, kPatience))
            qFatal("the block is not reached");
        return session.simulation().block();
    }
};

} // namespace proveout

QTEST_MAIN(proveout::BlockSearchTest)
#include "block_search_test.moc"
