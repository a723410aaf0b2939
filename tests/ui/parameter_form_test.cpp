// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/parameter_form.h"

#include <QComboBox>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>
#include <QToolButton>

#include "core/decimation/regions/region_decimator.h"

namespace proveout {

class ParameterFormTest : public QObject {
    Q_OBJECT

private slots:
    void anotherMethodBringsItsDefaults() {
        ParameterForm form;
        QSignalSpy edited(&form, &ParameterForm::edited);
        for (const DecimationMethodRow& method : decimationMethods()) {
            edited.clear();
            choose(form, method.method);
            QCOMPARE(edited.size(), 1);
            QCOMPARE(form.values().method, method.method);
            QCOMPARE(form.values().regionCells, method.defaultRegion);
            QCOMPARE(form.values().period, method.defaultPeriod);
            QCOMPARE(box(form, "region").value(), method.defaultRegion);
            QCOMPARE(box(form, "period").value(), method.defaultPeriod);
            QVERIFY2(box(form, "period").toolTip().endsWith(box(form, "period").text()),
                     qPrintable(box(form, "period").toolTip()));
        }
    }

    void aLargeMapHasLargerRegionsAsItsDefault() {
        ParameterForm form;
        form.show();
        form.setPoints(12e6);
        QVERIFY2(box(form, "region").toolTip().contains(QLatin1String("32")),
                 qPrintable(box(form, "region").toolTip()));
        DecimationParameters values;
        values.regionCells = 32;
        form.setValues(values);
        choose(form, DecimationMethod::lee);
        QCOMPARE(form.values().regionCells, defaultRegion(DecimationMethod::lee, 12e6));
        choose(form, DecimationMethod::certified);
        QCOMPARE(form.values().regionCells, 32);
    }

    void valuesOfTheUserStayWithAnotherMethod() {
        ParameterForm form;
        choose(form, DecimationMethod::lee);
        box(form, "region").setValue(16);
        choose(form, DecimationMethod::global);
        QCOMPARE(form.values().regionCells, 16);
        QCOMPARE(form.values().period, row(DecimationMethod::global).defaultPeriod);
    }

    void onlyWhatTheMethodLooksAtIsOffered() {
        ParameterForm form;
        form.show();
        const auto offers = [&form](const char* key) {
            const auto* editor = form.findChild<QWidget*>(QLatin1String(key));
            return editor->isVisible();
        };
        choose(form, DecimationMethod::lee);
        box(form, "seed").setValue(5);
        QVERIFY(offers("seed") && offers("certify") && !offers("level"));
        choose(form, DecimationMethod::certified);
        QVERIFY(!offers("seed") && !offers("certify") && offers("level"));
        for (const QToolButton* button : form.findChildren<QToolButton*>())
            QVERIFY2(!button->isVisible(), qPrintable(button->accessibleName()));
        choose(form, DecimationMethod::none);
        QVERIFY(offers("method") && !offers("region") && !offers("allowance"));
        QCOMPARE(form.values().seed, 5); // kept for the method that uses it
    }

private:
    static QSpinBox& box(ParameterForm& form, const char* key) {
        return *form.findChild<QSpinBox*>(QLatin1String(key));
    }
    static void choose(ParameterForm& form, DecimationMethod method) {
        auto* methods = form.findChild<QComboBox*>(QStringLiteral("method"));
        methods->setCurrentIndex(static_cast<int>(method));
        emit methods->activated(methods->currentIndex());
    }
};

} // namespace proveout

QTEST_MAIN(proveout::ParameterFormTest)
#include "parameter_form_test.moc"
