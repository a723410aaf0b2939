// SPDX-License-Identifier: GPL-3.0-or-later
// Every row of setup, decimation and machine has a widget with its range and its text, and is described in
// the guide.
#include <vector>

#include <QFile>
#include <QLabel>
#include <QLocale>
#include <QTest>

#include "core/simulation/setup/setup_fields.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/number_box.h"
#include "ui/setup/setup_panel.h"
#include "ui/tuning/tuning_panel.h"

namespace proveout {
namespace {

/// The widgets whose tooltip contains the help of the row, except labels.
std::vector<QWidget*> editorsOf(const QWidget& panel, const Field& field) {
    std::vector<QWidget*> editors;
    for (QWidget* widget : panel.findChildren<QWidget*>()) {
        if (qobject_cast<QLabel*>(widget) == nullptr && widget->toolTip().startsWith(coreText(field.help)))
            editors.push_back(widget);
    }
    return editors;
}

template<class Box>
bool hasRangeOf(const Box& box, const Field& field) {
    const QString range = QStringLiteral("Range: %1 to %2")
                              .arg(QLocale().toString(field.minimum, 'f', QLocale::FloatingPointShortest),
                                   QLocale().toString(field.maximum, 'f', QLocale::FloatingPointShortest));
    const QString unit = *field.unit == '\0' ? QString() : u' ' + QString::fromUtf8(field.unit);
    return static_cast<double>(box.range().minimum) == field.minimum &&
           static_cast<double>(box.range().maximum) == field.maximum && box.suffix() == unit &&
           box.toolTip().contains(range + unit);
}

/// What the panel lacks for a row; empty if it is complete.
template<class Value>
QString missing(const QWidget& panel, const Field& field) {
    const auto editors = editorsOf(panel, field);
    if (editors.empty())
        return QStringLiteral("%1: no widget").arg(QLatin1String(field.key));
    int boxes = 0;
    for (const QWidget* editor : editors) {
        if (const auto* number = qobject_cast<const NumberBox*>(editor)) {
            if (!hasRangeOf(*number, field) || number->decimals() != field.decimals)
                return QStringLiteral("%1: %2").arg(QLatin1String(field.key), number->toolTip());
            ++boxes;
        }
        if (const auto* count = qobject_cast<const CountBox*>(editor)) {
            if (!hasRangeOf(*count, field))
                return QStringLiteral("%1: %2").arg(QLatin1String(field.key), count->toolTip());
            ++boxes;
        }
    }
    const bool isNumber = std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>;
    return isNumber && boxes == 0 ? QStringLiteral("%1: no box").arg(QLatin1String(field.key)) : QString();
}

QString guidePage(const char* name) {
    QFile file(QStringLiteral(PROVEOUT_SOURCE_DIR "/resources/help/guide/") + QLatin1String(name));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// What panel and page lack for the rows of a struct.
template<class Params>
QString missing(const Params& params, const QWidget& panel, const char* page) {
    QStringList found;
    const QString guide = guidePage(page);
    describe(params, [&](const auto& value, const Field& field) {
        if (const QString lack = missing<std::remove_cvref_t<decltype(value)>>(panel, field); !lack.isEmpty())
            found << lack;
        if (!guide.contains(coreText(field.label)))
            found << QStringLiteral("%1: not in %2").arg(QLatin1String(field.key), QLatin1String(page));
    });
    return found.join(u'\n');
}

} // namespace

class PanelRowsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void ofTheSetupAreInItsPanelAndInTheGuide() {
        Session session;
        const SetupPanel panel(session);
        QCOMPARE(missing(Setup(), panel, "setup.md"), QString());
    }

    void ofTheMachineAreInTheSetupPanelAndInTheGuide() {
        Session session;
        const SetupPanel panel(session);
        QCOMPARE(missing(Machine(), panel, "setup.md"), QString());
    }

    void ofTheDecimationAreInTheTuningPanelAndInTheGuide() {
        Session session;
        const TuningPanel panel(session);
        QCOMPARE(missing(DecimationParameters(), panel, "tuning.md"), QString());
    }

    void theGridIsOnePlaceForBothPanels() {
        Session session;
        const TuningPanel panel(session);
        const Setup setup;
        describeGrid(setup, [&panel](const auto& value, const Field& field) {
            QCOMPARE(missing<std::remove_cvref_t<decltype(value)>>(panel, field), QString());
        });
    }
};

} // namespace proveout

QTEST_MAIN(proveout::PanelRowsTest)
#include "panel_rows_test.moc"
