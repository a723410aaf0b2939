// SPDX-License-Identifier: GPL-3.0-or-later
// The design part in the 3D view of a session: commands, legend, value under the pointer.
#include "ui/viewport/part_view.h"

#include <memory>

#include <QLabel>
#include <QMainWindow>
#include <QTest>

#include "tests/ui/opened.h"
#include "tests/ui/part_job.h"
#include "ui/gl/gl_functions.h"
#include "ui/readout/probe_text.h"
#include "ui/viewport/viewport.h"

namespace proveout {
namespace {

constexpr int kPatience = 30'000; ///< ms

QAction* command(const QWidget& widget, const char* id) {
    for (QAction* action : widget.actions())
        if (action->objectName() == QLatin1String(id))
            return action;
    return nullptr;
}

/// Until the stock of its program is there, and the part is read.
bool openedWhole(Session& session, const QString& job) {
    return opened(session, job) && QTest::qWaitFor(
                                       [&] {
                                           const FramePtr& frame = session.simulation().frame();
                                           return frame != nullptr && !session.program().isReading() &&
                                                  frame->program == session.program().current() &&
                                                  frame->program->blockCount() > 1 &&
                                                  !session.part().isReading();
                                       },
                                       kPatience);
}

bool goTo(Session& session, std::size_t block) {
    session.playback().seek(block);
    return QTest::qWaitFor(
        [&] {
            const FramePtr& frame = session.simulation().frame();
            return frame != nullptr && frame->block == block && frame->atRest;
        },
        kPatience);
}

bool isCompared(Session& session) {
    return QTest::qWaitFor(
        [&] { return session.part().comparison() != nullptr && !session.part().progress(); }, kPatience);
}

std::size_t pixelsLike(const QImage& image, const glm::vec3& colour) {
    std::size_t count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QColor pixel = image.pixelColor(x, y);
            const glm::vec3 seen(pixel.redF(), pixel.greenF(), pixel.blueF());
            count += glm::dot(glm::normalize(seen + 1e-6F), glm::normalize(colour)) > 0.99F ? 1 : 0;
        }
    return count;
}

} // namespace

class PartViewTest : public QObject {
    Q_OBJECT

private slots:
    void legendNamesTheBands() {
        using Band = DeviationLines::Band;
        DeviationLines lines = linesOf({{0.1, 0.125, 0}, {}}, QLocale::c());
        QCOMPARE(lines.title, QStringLiteral("Deviation from the part, mm"));
        const std::vector<std::pair<Band, QString>> bands{
            {Band::excess, QStringLiteral("> +0.125 (excess)")},
            {Band::left, QStringLiteral("0 … +0.125")},
            {Band::missing, QStringLiteral("0 … \u22120.10")},
            {Band::gouge, QStringLiteral("< \u22120.10 (gouge)")}};
        QVERIFY(lines.bands == bands);
        lines = linesOf({{0, 0.5, 0.3}, {}}, QLocale(QLocale::German));
        QCOMPARE(lines.title, QStringLiteral("Deviation from the part with allowance +0,30, mm"));
        QCOMPARE(lines.bands.size(), std::size_t{3});
        QCOMPARE(lines.bands.back().second, QStringLiteral("< \u22120,00 (gouge)"));
    }

    void legendReportsWhatIsNotColoured() {
        const PartJob job;
        Session session;
        SceneOptions options;
        QObject parent;
        auto* view = new PartView(session, options, &parent);
        const auto note = [&](Colouring colouring = Colouring::whole) {
            const auto legend = view->legend(*session.simulation().frame(), colouring);
            return legend ? legend->note : QStringLiteral("no legend");
        };
        QVERIFY(openedWhole(session, job.withoutPart) && goTo(session, 1));
        options.deviation = true;
        view->followOptions();
        QVERIFY(!view->isAvailable());
        QCOMPARE(note(), QStringLiteral("no legend"));

        options.deviation = false;
        view->followOptions();
        QVERIFY(openedWhole(session, job.withPart));
        QVERIFY(view->isAvailable() && goTo(session, 6));
        QCOMPARE(note(), QStringLiteral("no legend"));
        QVERIFY(view->part() == nullptr && view->comparison() == nullptr);
        options.deviation = true;
        options.part = true;
        view->followOptions();
        QVERIFY(view->part() == session.part().contents().part);
        QVERIFY(note().startsWith(QStringLiteral("Comparing: ")));
        QVERIFY(isCompared(session));
        QVERIFY(view->comparison() != nullptr);
        QCOMPARE(note(), QString());
        QCOMPARE(note(Colouring::tooLarge), QStringLiteral("Not enough graphics memory for these colours."));

        // A frame that is not at rest is not compared; the colours stay those of the last one that was.
        const FramePtr compared = session.simulation().frame();
        QVERIFY(goTo(session, session.program().blockCount()));
        QVERIFY(isCompared(session));
        QTRY_COMPARE(note(), QString());
        const auto old = view->legend(*compared, Colouring::whole);
        QCOMPARE(old->note, QStringLiteral("New cuts are compared when playback stops."));
    }

    void valueIsThatOfThePoint() {
        const PartJob job;
        Session session;
        const QObject user;
        session.part().setOn(user, true);
        QVERIFY(openedWhole(session, job.withPart));
        QVERIFY(goTo(session, session.program().blockCount()) && isCompared(session));
        const FramePtr frame = session.simulation().frame();
        const auto comparison = session.part().comparison();
        SurfaceProbe probe;
        const auto textAt = [&](const FramePtr& moment, int i, int j) {
            probe.point(SurfacePlace{{moment, MapPoint{i, j}}, {}});
            return deviationText(probe, comparison.get(), QLocale::c());
        };
        QCOMPARE(textAt(frame, 60, 10), QStringLiteral("Deviation \u22120.300 mm (gouge)"));
        QCOMPARE(textAt(frame, 20, 10), QStringLiteral("Deviation +0.000 mm"));
        QCOMPARE(textAt(frame, 20, 55), QStringLiteral("Deviation +2.000 mm (excess)"));
        QCOMPARE(deviationText(probe, nullptr, QLocale::c()), QString());
        QVERIFY(goTo(session, 1));
        QCOMPARE(textAt(session.simulation().frame(), 60, 10), QString()); // of other heights
    }

    void commandsAreThoseOfAPart() {
        const GlSupport support = probeGl();
        if (!support.usable)
            QSKIP("no OpenGL 3.3 here");
        const PartJob job;
        Session session;
        QMainWindow window;
        window.resize(900, 640);
        auto* view = new Viewport(session, support, &window);
        window.setCentralWidget(view);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QAction* colour = command(*view, "view-deviation");
        QAction* ghost = command(*view, "view-part");
        QVERIFY(!colour->isEnabled() && !ghost->isEnabled());
        QVERIFY(openedWhole(session, job.withoutPart));
        QVERIFY(!colour->isEnabled() && !ghost->isEnabled());
        QVERIFY(openedWhole(session, job.withPart));
        QVERIFY(colour->isEnabled() && ghost->isEnabled());
        QVERIFY(goTo(session, session.program().blockCount()));
        view->setOptions([&] {
            SceneOptions options = view->options();
            options.path = PathShown::none;
            options.cutter = CutterShown::hidden;
            return options;
        }());
        view->setLegendShown(false);
        const DeviationColours colours;
        QVERIFY(pixelsLike(view->grabFramebuffer(), colours.gouge) < 50);

        colour->trigger();
        QVERIFY(colour->isChecked() && view->options().deviation);
        QVERIFY(isCompared(session));
        QTRY_VERIFY_WITH_TIMEOUT(pixelsLike(view->grabFramebuffer(), colours.gouge) > 2000, kPatience);
        QVERIFY(pixelsLike(view->grabFramebuffer(), colours.excess) > 1000);
        ghost->trigger();
        QVERIFY(ghost->isChecked() && view->options().part);
        colour->trigger();
        QVERIFY(session.part().comparison() == nullptr); // nobody looks
        QTRY_VERIFY_WITH_TIMEOUT(pixelsLike(view->grabFramebuffer(), colours.gouge) < 50, kPatience);
        QVERIFY(openedWhole(session, job.withoutPart));
        QVERIFY(!colour->isEnabled() && !ghost->isEnabled() && ghost->isChecked());
        (void)view->grabFramebuffer();
    }
};

} // namespace proveout

QTEST_MAIN(proveout::PartViewTest)

#include "part_view_test.moc"
