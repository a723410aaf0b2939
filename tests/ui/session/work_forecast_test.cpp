// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/work_forecast.h"

#include <QTest>

namespace proveout {

class WorkForecastTest : public QObject {
    Q_OBJECT

private slots:
    void tellsNothingBeforeItCan() {
        WorkForecast forecast;
        forecast.follow(0, 10);
        forecast.follow(0.5, 11.9); // too early
        QVERIFY(!forecast.secondsLeft());
        forecast.follow(0, 12);
        forecast.follow(0.01, 40); // too little
        QVERIFY(!forecast.secondsLeft());
    }

    void goesOnAsItWent() {
        WorkForecast forecast;
        forecast.follow(0, 100);
        forecast.follow(0.25, 105);
        QCOMPARE(forecast.secondsLeft(), std::optional<int>(15));
        forecast.follow(0.5, 111); // 11 s
        QCOMPARE(forecast.secondsLeft(), std::optional<int>(15));
        forecast.follow(0.9, 119);
        QCOMPARE(forecast.secondsLeft(), std::optional<int>(5));
        forecast.follow(0.99, 121);
        QVERIFY(!forecast.secondsLeft()); // about to end
    }

    void countsFromWhereItBegan() {
        WorkForecast forecast;
        forecast.follow(0.8, 0); // e.g. a seek that goes on after another one
        forecast.follow(0.9, 10);
        QCOMPARE(forecast.secondsLeft(), std::optional<int>(10));
    }

    void longTimesAreRoundedToHalfMinutes() {
        WorkForecast forecast;
        forecast.follow(0, 0);
        forecast.follow(0.1, 10); // 90 s
        QCOMPARE(forecast.secondsLeft(), std::optional<int>(90));
        forecast.follow(0.1, 11); // 99 s
        QCOMPARE(forecast.secondsLeft(), std::optional<int>(120));
    }

    void fallingProgressIsAnotherOperation() {
        WorkForecast forecast;
        forecast.follow(0, 0);
        forecast.follow(0.5, 10);
        QCOMPARE(forecast.secondsLeft(), std::optional<int>(10));
        forecast.follow(0.1, 11);
        QVERIFY(!forecast.secondsLeft());
        forecast.follow(0.4, 14);
        QCOMPARE(forecast.secondsLeft(), std::optional<int>(10));
        forecast.end();
        QVERIFY(!forecast.secondsLeft());
    }
};

} // namespace proveout

QTEST_GUILESS_MAIN(proveout::WorkForecastTest)
#include "work_forecast_test.moc"
