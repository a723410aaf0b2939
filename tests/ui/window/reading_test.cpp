// SPDX-License-Identifier: GPL-3.0-or-later
// In every language and at every width of the docks, all texts of a panel are completely readable.
#include <memory>

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QStatusBar>
#include <QStyleOptionComboBox>
#include <QTest>

#include "tests/ui/window/workstation.h"
#include "ui/look/languages.h"

namespace proveout {
namespace {

/// The width of a box that is available for its text.
int roomOf(const QComboBox& box) {
    QStyleOptionComboBox option;
    option.initFrom(&box);
    return box.style()
        ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box)
        .width();
}

/// Texts in `dock` that are cut off, with the missing pixels.
QStringList cutOff(const QDockWidget& dock) {
    QStringList found;
    const auto check = [&](const QWidget& widget, const QString& text, int room, int needed) {
        if (widget.isVisible() && room < needed)
            found << QStringLiteral("%1: %2 px for %3 px").arg(text).arg(room).arg(needed);
    };
    for (const QComboBox* box : dock.findChildren<QComboBox*>())
        for (int i = 0; i < box->count(); ++i)
            check(*box, box->itemText(i), roomOf(*box),
                  box->fontMetrics().horizontalAdvance(box->itemText(i)));
    for (const QLabel* label : dock.findChildren<QLabel*>())
        if (!label->wordWrap() && !label->text().isEmpty())
            check(*label, label->text(), label->width(), label->sizeHint().width());
    for (const QAbstractButton* button : dock.findChildren<QAbstractButton*>())
        if (!button->text().isEmpty())
            check(*button, button->text(), button->width(), button->sizeHint().width());
    for (QAbstractSpinBox* box : dock.findChildren<QAbstractSpinBox*>()) {
        const auto* edit = box->findChild<QLineEdit*>();
        check(*box, box->text(), edit->width(), box->fontMetrics().horizontalAdvance(box->text()) + 4);
    }
    // Nothing may extend beyond the right edge of a panel that cannot be scrolled horizontally.
    for (const QWidget* widget : dock.findChildren<QWidget*>()) {
        const bool field = qobject_cast<const QComboBox*>(widget) != nullptr ||
                           qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
                           qobject_cast<const QAbstractButton*>(widget) != nullptr;
        if (field)
            check(*widget, widget->objectName(), dock.width(),
                  widget->mapTo(&dock, widget->rect().topRight()).x() + 1);
    }
    return found;
}

} // namespace

class ReadingTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings = std::make_unique<OwnSettings>(); }

    void textsEndInSightInEveryLanguage_data() {
        QTest::addColumn<QString>("language");
        for (const Language& language : languages())
            QTest::newRow(qPrintable(language.code)) << language.code;
    }
    void textsEndInSightInEveryLanguage() {
        QFETCH(QString, language);
        Workstation station(true);
        station.appearance.setLanguage(language); // boxes have cached their sizes
        QTest::qWait(100);
        for (const char* id : {"dock-setup", "dock-tuning", "dock-timeline"}) {
            auto* dock = station.window.findChild<QDockWidget*>(QLatin1String(id));
            dock->raise();
            station.window.resizeDocks({dock}, {1}, Qt::Horizontal);
            QTest::qWait(200); // until the layouts are updated
            QStringList found;
            const auto settled = [&] { return (found = cutOff(*dock)).isEmpty(); };
            QVERIFY2(QTest::qWaitFor(settled, kPatience), qPrintable(QStringLiteral("%1 is %2 px wide\n%3")
                                                                         .arg(QLatin1String(id))
                                                                         .arg(dock->width())
                                                                         .arg(found.join(u'\n'))));
        }
        station.appearance.setLanguage(QStringLiteral("en"));
    }

    void theStatusBarHoldsLargeNumbers_data() { textsEndInSightInEveryLanguage_data(); }
    void theStatusBarHoldsLargeNumbers() {
        QFETCH(QString, language);
        Workstation station(true);
        station.appearance.setLanguage(language);
        Setup setup = station.session.job().setup();
        setup.automaticGrid = false;
        setup.spacing = 0.12;
        QVERIFY(station.session.job().setSetup(setup));
        DecimationParameters never = station.session.job().parameters();
        never.period = 0;
        station.session.job().setParameters(never);
        const auto fine = [&] {
            return station.session.simulation().frame() &&
                   station.session.simulation().frame()->surface.faces > 1'000'000;
        };
        QVERIFY(QTest::qWaitFor(fine, kPatience));
        const QString faces =
            QLocale().toString(qulonglong{station.session.simulation().frame()->surface.facesFull});
        const auto find = [&]() -> const QLabel* {
            for (const QLabel* label : station.window.statusBar()->findChildren<QLabel*>())
                if (label->text().endsWith(faces))
                    return label;
            return nullptr;
        };
        QTRY_VERIFY_WITH_TIMEOUT(find() != nullptr, kPatience);
        for (const QLabel* label : station.window.statusBar()->findChildren<QLabel*>())
            QVERIFY2(!label->isVisible() || label->width() >= label->sizeHint().width(),
                     qPrintable(label->text()));
        station.appearance.setLanguage(QStringLiteral("en"));
    }

private:
    std::unique_ptr<OwnSettings> m_settings;
};

} // namespace proveout

int main(int argc, char** argv) {
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    proveout::ReadingTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "reading_test.moc"
