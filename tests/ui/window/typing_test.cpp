// SPDX-License-Identifier: GPL-3.0-or-later
// Text typed into the forms: nothing overwrites it, and saving or closing applies it first.
#include <functional>
#include <memory>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLineEdit>
#include <QMessageBox>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "core/cutter/cutter.h"
#include "tests/ui/window/workstation.h"
#include "ui/look/number_box.h"

namespace proveout {
namespace {

constexpr int kRest = 400; ///< ms; longer than any form waits for the next key

/// The window with a saved job and one of its inputs visible.
struct Bench {
    QTemporaryDir folder;
    Workstation station{true};

    Bench() {
        if (!session().document().saveAs(folder.filePath(QStringLiteral("part.nc"))) ||
            !session().document().saveJobAs(folder.filePath(QStringLiteral("part.proveout"))))
            qFatal("the job cannot be saved");
    }
    template<class Input = QDoubleSpinBox>
    Input& find(const char* dock, const char* name) {
        auto* panel = station.window.findChild<QDockWidget*>(QLatin1String(dock));
        panel->show();
        panel->raise();
        auto* found = panel->findChild<Input*>(QLatin1String(name));
        if (found == nullptr || !QTest::qWaitFor([&] { return found->isVisible(); }, kPatience))
            qFatal("%s is not seen", name);
        return *found;
    }
    /// Focuses an input and selects its text, as Tab does.
    template<class Input = QDoubleSpinBox>
    Input& reached(const char* dock, const char* name) {
        Input& input = find<Input>(dock, name);
        input.setFocus(Qt::TabFocusReason);
        if (!QTest::qWaitFor([&] { return input.hasFocus(); }, kPatience))
            qFatal("%s does not get the focus", name);
        return input;
    }
    Session& session() { return station.session; }
    const Setup& setup() { return session().job().setup(); }
    /// Changes the setup from outside the form, as reading a program does.
    void changeSetup(const std::function<void(Setup&)>& edit) {
        Setup changed = setup();
        edit(changed);
        if (!session().job().setSetup(changed))
            qFatal("the setup is refused");
    }
    void addTool(int number) {
        changeSetup([number](Setup& changed) { changed.tools.set(number, parseCutter("flat:d=9").value()); });
    }
};

/// Presses a button in each question, and counts the questions.
class Answer {
public:
    explicit Answer(QMessageBox::StandardButton button) {
        QObject::connect(&m_look, &QTimer::timeout, [this, button] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (box == nullptr || box == m_answered)
                return;
            m_answered = box;
            ++m_asked;
            QMetaObject::invokeMethod(box->button(button), "click", Qt::QueuedConnection);
        });
        m_look.start(20);
    }
    [[nodiscard]] int asked() const { return m_asked; }

private:
    QTimer m_look;
    const QMessageBox* m_answered = nullptr;
    int m_asked = 0;
};

void keys(QWidget& input, const QString& text) {
    QTest::keyClicks(&input, text);
}

/// Moves to the next input in the window's tab sequence.
QWidget& tab(QWidget& input) {
    QTest::keyClick(&input, Qt::Key_Tab);
    return *QApplication::focusWidget();
}

} // namespace

class TypingTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings = std::make_unique<OwnSettings>(); }

    void aPauseWithinANumberChangesNothing() {
        Bench bench;
        auto& width = bench.reached("dock-setup", "stock-width");
        keys(width, QStringLiteral("100"));
        QWidget& depth = tab(width);
        QCOMPARE(depth.objectName(), QStringLiteral("stock-depth"));
        keys(depth, QStringLiteral("5"));
        QTest::qWait(kRest); // the width is applied meanwhile
        QCOMPARE(bench.setup().stock.width, 100.0);
        keys(depth, QStringLiteral("0"));
        QWidget& height = tab(depth);
        QTRY_COMPARE_WITH_TIMEOUT(bench.setup().stock.depth, 50.0, kPatience);
        QVERIFY(&height != &depth);
    }

    void theStartPositionIsTypedWhileTheProgramIsRead() {
        Bench bench;
        auto& known = bench.find<QCheckBox>("dock-setup", "start-known");
        known.setFocus();
        QTest::keyClick(&known, Qt::Key_Space);
        auto& x = bench.reached("dock-setup", "start-x");
        keys(x, QStringLiteral("12"));
        QWidget& y = tab(x);
        QCOMPARE(y.objectName(), QStringLiteral("start-y"));
        keys(y, QStringLiteral("5"));
        QTRY_VERIFY_WITH_TIMEOUT(bench.setup().start && bench.setup().start->x == 12, kPatience);
        QTest::qWait(kRest);
        keys(y, QStringLiteral("0"));
        tab(y);
        QTRY_VERIFY_WITH_TIMEOUT(bench.setup().start && bench.setup().start->y == 50, kPatience);
        QCOMPARE(bench.setup().start->x, 12.0);
    }

    void whatIsTypedInAnyBoxStaysWhenOthersChangeTheSetup_data() {
        QTest::addColumn<QByteArray>("dock");
        QTest::addColumn<QByteArray>("name");
        for (const char* name : {"stock-width", "stock-height", "corner-x", "corner-z", "spacing", "tool-d",
                                 "tool-l", "rapidXY", "rapidZ"})
            QTest::newRow(name) << QByteArray("dock-setup") << QByteArray(name);
        for (const char* name : {"allowance", "region", "period", "grid"})
            QTest::newRow(name) << QByteArray("dock-tuning") << QByteArray(name);
    }
    void whatIsTypedInAnyBoxStaysWhenOthersChangeTheSetup() {
        QFETCH(QByteArray, dock);
        QFETCH(QByteArray, name);
        Bench bench;
        auto& box = bench.reached<QAbstractSpinBox>(dock.constData(), name.constData());
        keys(box, QStringLiteral("7"));
        const QString typed = box.text();
        QVERIFY(typed.startsWith(u'7'));
        bench.addTool(77);
        QTest::qWait(kRest);
        QCOMPARE(box.text(), typed);
        QTest::keyClick(&box, Qt::Key_Z, Qt::ControlModifier); // undoes only in the text
        QVERIFY2(box.text() != typed, qPrintable(typed));
        QVERIFY(bench.setup().tools.find(77) != nullptr);
    }

    /// The box still receives the new value, which is restored if typing is abandoned.
    void aValueThatOthersSetIsThereBelowTheTypedText() {
        Bench bench;
        auto& width = bench.reached("dock-setup", "stock-width");
        keys(width, QStringLiteral("7"));
        bench.changeSetup([](Setup& setup) { setup.stock.width = 61; });
        QCOMPARE(width.value(), 61.0);
        QVERIFY(width.text().startsWith(QStringLiteral("7 ")));
        QTest::keyClick(&width, Qt::Key_Backspace); // not a number, so the current value stays
        QTest::keyClick(&width, Qt::Key_Return);
        QTest::qWait(kRest);
        QCOMPARE(bench.setup().stock.width, 61.0);
    }

    void aLineOfTextIsNotOverwrittenEither() {
        Bench bench;
        auto& codes = bench.reached<QLineEdit>("dock-setup", "ignored-m");
        keys(codes, QStringLiteral("1"));
        bench.addTool(77);
        QTest::qWait(kRest);
        QCOMPARE(codes.text(), QStringLiteral("1"));
        keys(codes, QStringLiteral("6"));
        QTest::keyClick(&codes, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(bench.setup().ignoredM, (std::set<int>{16}), kPatience);
        auto& shape = bench.find<QComboBox>("dock-setup", "stock-shape");
        shape.setFocus();
        QTest::keyClick(&shape, Qt::Key_End);
        auto& file = bench.reached<QLineEdit>("dock-setup", "stock-file-file");
        QTRY_COMPARE_WITH_TIMEOUT(bench.setup().shape.kind, StockKind::saved, kPatience);
        keys(file, QStringLiteral("ab"));
        bench.addTool(78);
        QTest::qWait(kRest);
        QCOMPARE(file.text(), QStringLiteral("ab"));
    }

    void aWrongListOfCodesWaitsForItsCorrection() {
        Bench bench;
        auto& codes = bench.reached<QLineEdit>("dock-setup", "ignored-m");
        keys(codes, QStringLiteral("1x"));
        tab(codes);
        bench.addTool(77);
        QTest::qWait(kRest);
        QCOMPARE(codes.text(), QStringLiteral("1x"));
        bench.session().document().newFile();
        QVERIFY(codes.text().isEmpty());
    }

    /// An edit is applied after a delay, and the setup may change before that.
    void anEditThatIsHeldBackIsNotDropped() {
        Bench bench;
        auto& kind = bench.reached<QComboBox>("dock-setup", "dialect");
        QTest::keyClick(&kind, Qt::Key_Down);
        const int chosen = kind.currentIndex();
        QVERIFY(chosen > 0 && !bench.setup().dialect);
        auto& corner = bench.reached("dock-setup", "corner-x");
        QTest::keyClick(&corner, Qt::Key_Up);
        const double left = corner.value();
        bench.addTool(77); // applied immediately
        emit bench.session().program().changed();
        QCOMPARE(kind.currentIndex(), chosen);
        QCOMPARE(corner.value(), left);
        QTRY_VERIFY_WITH_TIMEOUT(bench.setup().dialect.has_value(), kPatience);
        QCOMPARE(bench.setup().stock.corner.x, left);
        QVERIFY(bench.setup().tools.find(77) != nullptr);
    }

    void aParameterThatIsHeldBackIsNotDropped() {
        Bench bench;
        auto& allowance = bench.reached("dock-tuning", "allowance");
        keys(allowance, QStringLiteral("0.2"));
        QTest::keyClick(&allowance, Qt::Key_Return);
        DecimationParameters others = bench.session().job().parameters();
        others.period = 9;
        bench.session().job().setParameters(others);
        QTRY_COMPARE_WITH_TIMEOUT(bench.session().job().parameters().allowance, 0.2, kPatience);
        QCOMPARE(bench.session().job().parameters().period, 9);
        auto& grid = bench.reached("dock-tuning", "grid");
        keys(grid, QStringLiteral("2"));
        QTest::keyClick(&grid, Qt::Key_Return);
        bench.addTool(77);
        QTRY_COMPARE_WITH_TIMEOUT(bench.setup().spacing, 2.0, kPatience);
        QVERIFY(!bench.setup().automaticGrid);
        QVERIFY(bench.setup().tools.find(77) != nullptr);
    }

    void whatIsHeldBackDoesNotReachAnotherDocument() {
        Bench bench;
        auto& corner = bench.reached("dock-setup", "corner-x");
        QTest::keyClick(&corner, Qt::Key_Up);
        bench.session().document().newFile();
        Setup fresh = bench.setup();
        QTest::qWait(kRest);
        fresh.spacing = bench.setup().spacing; // computed once the new text is interpreted
        QVERIFY(bench.setup() == fresh);
        QVERIFY(!bench.session().document().modified());
    }

    void saveAndCloseTakeWhatIsTyped_data() {
        QTest::addColumn<QByteArray>("dock");
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QString>("typed");
        QTest::addColumn<QByteArray>("saved");
        QTest::newRow("setup") << QByteArray("dock-setup") << QByteArray("corner-z") << QStringLiteral("7.25")
                               << QByteArray("7.25");
        QTest::newRow("machine") << QByteArray("dock-setup") << QByteArray("rapidZ") << QStringLiteral("9123")
                                 << QByteArray("9123");
        QTest::newRow("tuning") << QByteArray("dock-tuning") << QByteArray("allowance")
                                << QStringLiteral("0.123") << QByteArray("0.123");
        QTest::newRow("a list") << QByteArray("dock-setup") << QByteArray("ignored-m")
                                << QStringLiteral("919") << QByteArray("919");
    }
    void saveAndCloseTakeWhatIsTyped() {
        QFETCH(QByteArray, dock);
        QFETCH(QByteArray, name);
        QFETCH(QString, typed);
        QFETCH(QByteArray, saved);
        Bench bench;
        auto& input = bench.reached<QWidget>(dock.constData(), name.constData());
        keys(input, typed);
        {
            Answer answer(QMessageBox::Cancel); // the window stays open, and the input unchanged
            QTest::keyClick(&bench.station.window, Qt::Key_Q, Qt::ControlModifier);
            QCOMPARE(answer.asked(), 1);
        }
        QVERIFY(bench.station.window.isVisible());
        bench.station.press(Qt::Key_S, Qt::ControlModifier);
        QFile job(bench.session().document().jobFile());
        QVERIFY(job.open(QIODevice::ReadOnly));
        QVERIFY2(job.readAll().contains(saved), saved.constData());
        QVERIFY(!bench.session().document().modified());
        QTest::qWait(kRest);
        QVERIFY(!bench.session().document().modified()); // the modified mark does not reappear
    }

    void aValueOutOfRangeWidensNoRange() {
        Bench bench;
        bench.changeSetup([](Setup& setup) {
            setup.stock.width = setup.stock.depth = 9000;
            setup.automaticGrid = false;
            setup.spacing = 1500;
        });
        auto& spacing = bench.reached<NumberBox>("dock-setup", "spacing");
        QCOMPARE(spacing.value(), 1500.0);
        keys(spacing, QStringLiteral("1400"));
        QTest::keyClick(&spacing, Qt::Key_Return);
        QTest::qWait(kRest);
        QCOMPARE(bench.setup().spacing, 1500.0);
    }

private:
    std::unique_ptr<OwnSettings> m_settings;
};

} // namespace proveout

int main(int argc, char** argv) {
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    proveout::TypingTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "typing_test.moc"
