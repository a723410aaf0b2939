// SPDX-License-Identifier: GPL-3.0-or-later
// Inputs of the window's panels: clicks on widgets that their own change rebuilds, and the wheel over all of
// them.
#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <vector>

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPointer>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QSpinBox>
#include <QTest>
#include <QTreeWidget>
#include <QWheelEvent>

#include "tests/ui/window/workstation.h"
#include "ui/editor/editor_panel.h"
#include "ui/editor/nc_editor.h"

namespace proveout {
namespace {

constexpr int kNotch = QWheelEvent::DefaultDeltasPerStep;

/// The value shown by an input of any type.
QString valueOf(const QWidget& input) {
    if (const auto* box = qobject_cast<const QComboBox*>(&input))
        return QString::number(box->currentIndex()) + box->currentText();
    if (const auto* box = qobject_cast<const QSpinBox*>(&input))
        return QString::number(box->value());
    if (const auto* box = qobject_cast<const QDoubleSpinBox*>(&input))
        return QString::number(box->value(), 'g', 17);
    if (const auto* slider = qobject_cast<const QAbstractSlider*>(&input))
        return QString::number(slider->value());
    return {};
}

/// Every spin box, combo box and slider of a window, in any panel.
QList<QWidget*> inputsOf(const QWidget& window) {
    QList<QWidget*> inputs;
    for (QWidget* widget : window.findChildren<QWidget*>()) {
        const bool slider =
            qobject_cast<QAbstractSlider*>(widget) != nullptr && qobject_cast<QScrollBar*>(widget) == nullptr;
        if (slider || qobject_cast<QAbstractSpinBox*>(widget) != nullptr ||
            qobject_cast<QComboBox*>(widget) != nullptr)
            inputs << widget;
    }
    return inputs;
}

/// Sends the event as the display does: to the widget under the pointer, which may take the focus.
void turnWheel(QWidget& target, int angle) {
    const QPoint middle = target.rect().center();
    QWidget* under = target.childAt(middle);
    QWidget& receiver = under != nullptr ? *under : target;
    const QPointF local = receiver.mapFrom(&target, QPointF(middle));
    QWheelEvent event(local, target.mapToGlobal(QPointF(middle)), {}, {0, angle}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QSpontaneKeyEvent::setSpontaneous(&event);
    qApp->notify(&receiver, &event);
}

/// Moves the value away from its limits, so that both directions change it.
void leaveTheLimits(QWidget& input) {
    const QSignalBlocker quiet(&input);
    if (auto* box = qobject_cast<QComboBox*>(&input); box != nullptr && box->count() > 1)
        box->setCurrentIndex(box->count() / 2);
    if (auto* box = qobject_cast<QAbstractSpinBox*>(&input))
        box->stepBy(1);
    if (auto* slider = qobject_cast<QAbstractSlider*>(&input))
        slider->setValue((slider->minimum() + slider->maximum()) / 2);
}

bool hasFocusInside(const QWidget& widget) {
    const QWidget* focus = QApplication::focusWidget();
    return focus != nullptr && (focus == &widget || widget.isAncestorOf(focus));
}

QDockWidget& dockOf(const Workstation& station, const char* id) {
    return *station.window.findChild<QDockWidget*>(QLatin1String(id));
}

Breakpoint atLine(std::uint32_t line) {
    Breakpoint breakpoint;
    breakpoint.line = line;
    return breakpoint;
}

Breakpoint onCondition(const char* condition) {
    Breakpoint breakpoint;
    breakpoint.kind = BreakpointKind::condition;
    breakpoint.condition = condition;
    return breakpoint;
}

/// The position of a row's check box, according to the style's layout of an item.
QPoint checkBoxOf(const QTreeWidget& list, int row) {
    const QRect cell = list.visualItemRect(list.topLevelItem(row));
    return {cell.left() + 10, cell.center().y()};
}

} // namespace

class InputTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings = std::make_unique<OwnSettings>(); }

    void aClickOnTheCheckBoxOfABreakpointSwitchesIt() {
        Workstation station(true);
        Session& session = station.session;
        QDockWidget& dock = dockOf(station, "dock-breakpoints");
        dock.raise();
        auto* list = dock.findChild<QTreeWidget*>();
        session.breakpoints().set({atLine(12), onCondition("Z < -2"), atLine(30)});
        QTRY_VERIFY_WITH_TIMEOUT(list->isVisible() && list->topLevelItemCount() == 3, kPatience);
        const QTreeWidgetItem* second = list->topLevelItem(1);
        for (const bool on : {false, true, false}) {
            QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, checkBoxOf(*list, 1));
            QCOMPARE(session.breakpoints().all()[1].enabled, on);
            QVERIFY(session.breakpoints().all()[0].enabled && session.breakpoints().all()[2].enabled);
            QCOMPARE(list->topLevelItem(1), second); // it survives its own change
            QCOMPARE(second->checkState(0) == Qt::Checked, on);
        }
        // By keyboard; the row stays selected.
        list->setFocus();
        list->setCurrentItem(list->topLevelItem(1));
        QTest::keyClick(list, Qt::Key_Space);
        QVERIFY(session.breakpoints().all()[1].enabled);
        QCOMPARE(list->selectedItems(), QList<QTreeWidgetItem*>{list->topLevelItem(1)});
        QTest::keyClick(list, Qt::Key_Delete);
        QCOMPARE(session.breakpoints().all().size(), std::size_t{2});
        QCOMPARE(session.breakpoints().all()[1].line, 30U);
        QVERIFY(list->selectedItems().isEmpty()); // so Delete removes no other row
    }

    /// Operates every row, box and check box once: widgets that are handling an event must not be rebuilt.
    void workingEveryInputBreaksNothing() {
        Workstation station(true);
        station.session.breakpoints().set({atLine(12), onCondition("Z < -2")});
        for (QDockWidget* dock : station.window.findChildren<QDockWidget*>()) {
            dock->show();
            dock->raise();
            QTest::qWait(50);
            for (QTreeView* list : dock->findChildren<QTreeView*>())
                workList(*list);
            for (const QPointer<QWidget>& input : guarded(inputsOf(*dock))) {
                if (!input || !input->isVisible() || !input->isEnabled())
                    continue;
                input->setFocus();
                for (const Qt::Key key : {Qt::Key_Up, Qt::Key_Down, Qt::Key_Down, Qt::Key_Return}) {
                    if (input)
                        QTest::keyClick(input, key);
                }
                QTest::qWait(5);
            }
            for (const QPointer<QCheckBox>& box : guarded(dock->findChildren<QCheckBox*>())) {
                if (box && box->isVisible())
                    QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
            }
        }
        QTest::qWait(600); // the delay after which input is applied
        QTRY_VERIFY_WITH_TIMEOUT(station.session.program().current() != nullptr, kPatience);
        QVERIFY(station.window.isVisible());
    }

    void theWheelChangesNothingThatHasNotTheFocus() {
        Workstation station(true);
        if (QAction* look = station.window.action(QStringLiteral("look-closer")))
            look->trigger(); // its form also has inputs
        std::vector<QWidget*> panels{station.window.centralWidget()};
        for (QDockWidget* dock : station.window.findChildren<QDockWidget*>())
            panels.push_back(dock);
        int tried = 0;
        for (QWidget* panel : panels) {
            if (auto* dock = qobject_cast<QDockWidget*>(panel)) {
                dock->show();
                dock->raise();
            }
            QTest::qWait(20);
            station.scale().setFocus(); // always visible
            for (QWidget* input : inputsOf(*panel)) {
                if (!input->isVisible() || !input->isEnabled())
                    continue;
                leaveTheLimits(*input);
                const QWidget* before = QApplication::focusWidget();
                const QString value = valueOf(*input);
                for (const int angle : {kNotch, -kNotch, -kNotch})
                    turnWheel(*input, angle);
                QVERIFY2(valueOf(*input) == value, qPrintable(input->objectName() + u' ' + value));
                QVERIFY2(QApplication::focusWidget() == before, qPrintable(input->objectName()));
                ++tried;
            }
        }
        QVERIFY(tried >= 20);
    }

    void anInputWithTheFocusTakesTheWheel() {
        Workstation station(true);
        dockOf(station, "dock-tuning").raise();
        auto* period = station.window.findChild<QSpinBox*>(QStringLiteral("period"));
        QTRY_VERIFY_WITH_TIMEOUT(period->isVisible(), kPatience);
        const int value = period->value();
        period->setFocus();
        turnWheel(*period, kNotch);
        QCOMPARE(period->value(), value + 1);
        // The adjacent combo box stays unchanged.
        auto* method = station.window.findChild<QComboBox*>(QStringLiteral("method"));
        turnWheel(*method, -kNotch);
        QCOMPARE(method->currentIndex(), 0);
        method->setFocus();
        turnWheel(*method, -kNotch);
        QCOMPARE(method->currentIndex(), 1);
    }

    void thePanelScrollsUnderTheWheelInstead() {
        Workstation station(true);
        QDockWidget& dock = dockOf(station, "dock-setup");
        dock.raise();
        auto* top = dock.findChild<QDoubleSpinBox*>(QStringLiteral("corner-z"));
        QTRY_VERIFY_WITH_TIMEOUT(top->isVisible(), kPatience);
        QScrollBar* bar = dock.findChild<QScrollArea*>()->verticalScrollBar();
        QTRY_VERIFY_WITH_TIMEOUT(bar->maximum() > 0, kPatience);
        const double value = top->value();
        turnWheel(*top, -kNotch);
        QCOMPARE(top->value(), value);
        QVERIFY(bar->value() > 0);
    }

    void theTimelineTakesTheWheelOnlyWithTheFocus() {
        Workstation station(true);
        station.session.playback().seek(20);
        QTRY_COMPARE_WITH_TIMEOUT(station.session.simulation().block(), std::size_t{20}, kPatience);
        station.window.viewport().setFocus();
        turnWheel(station.scale(), -kNotch);
        QTest::qWait(200);
        QCOMPARE(station.session.simulation().block(), std::size_t{20});
        station.scale().setFocus();
        turnWheel(station.scale(), -kNotch);
        QTRY_COMPARE_WITH_TIMEOUT(station.session.simulation().block(), std::size_t{21}, kPatience);
    }

    void widgetsMadeLaterAndDialogsAreNoExceptions() {
        Workstation station(false);
        QDialog dialog(&station.window);
        auto* text = new QLineEdit(&dialog);
        auto* number = new QSpinBox(&dialog);
        auto* choice = new QComboBox(&dialog);
        auto* slider = new QSlider(Qt::Horizontal, &dialog);
        choice->addItems({"a", "b", "c"});
        int y = 0;
        for (QWidget* widget : std::initializer_list<QWidget*>{text, number, choice, slider})
            widget->setGeometry(0, y++ * 40, 120, 30);
        dialog.resize(200, 200);
        dialog.setModal(true);
        text->setFocus();
        dialog.show();
        dialog.activateWindow();
        QTRY_COMPARE_WITH_TIMEOUT(QApplication::focusWidget(), text, kPatience);
        for (QWidget* input : std::initializer_list<QWidget*>{number, choice, slider}) {
            leaveTheLimits(*input);
            const QString value = valueOf(*input);
            turnWheel(*input, kNotch);
            QCOMPARE(valueOf(*input), value);
            QCOMPARE(QApplication::focusWidget(), text);
            input->setFocus();
            turnWheel(*input, kNotch);
            QVERIFY(valueOf(*input) != value);
            text->setFocus();
        }
    }

    void theWheelOverTextMovesNoFocus() {
        Workstation station(true);
        station.scale().setFocus();
        turnWheel(*station.window.editor().editor().viewport(), -kNotch);
        QVERIFY(hasFocusInside(station.scale()));
        dockOf(station, "dock-problems").raise();
        QTest::qWait(20);
        for (QTreeView* list : station.window.findChildren<QTreeView*>()) {
            turnWheel(*list->viewport(), -kNotch);
            QVERIFY(hasFocusInside(station.scale()));
        }
    }

private:
    /// Guarded, because forms are rebuilt by their own inputs.
    template<class Widget>
    static QList<QPointer<Widget>> guarded(const QList<Widget*>& widgets) {
        return {widgets.begin(), widgets.end()};
    }

    static void workList(QTreeView& list) {
        if (!list.isVisible() || list.model() == nullptr)
            return;
        list.setFocus();
        for (int row = 0; row < std::min(list.model()->rowCount(), 4); ++row) {
            const QRect cell = list.visualRect(list.model()->index(row, 0));
            for (const int x : {cell.left() + 10, cell.center().x()})
                QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, QPoint(x, cell.center().y()));
            QTest::mouseDClick(list.viewport(), Qt::LeftButton, {}, cell.center());
            for (const Qt::Key key : {Qt::Key_Space, Qt::Key_Return, Qt::Key_Down})
                QTest::keyClick(&list, key);
        }
    }

    std::unique_ptr<OwnSettings> m_settings;
};

} // namespace proveout

int main(int argc, char** argv) {
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    proveout::InputTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "input_test.moc"
