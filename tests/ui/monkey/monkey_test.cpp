// SPDX-License-Identifier: GPL-3.0-or-later
// A monkey test of the real window. PROVEOUT_SEED and PROVEOUT_MONKEY_SECONDS set its actions and its
// duration.
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <thread>

#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/random_seed.h"
#include "tests/ui/monkey/monkey.h"

namespace proveout {
namespace {

constexpr int kSeconds = 30;    // default duration
constexpr int kLongestGap = 60; // seconds that an action may take at most, with sanitizers
constexpr int kLinesOfLog = 25;

int secondsOfMonkey() {
    const char* chosen = std::getenv("PROVEOUT_MONKEY_SECONDS");
    return chosen == nullptr ? kSeconds : std::atoi(chosen);
}

void printEndOfLog(const QString& name) {
    QFile log(name);
    if (!log.open(QIODevice::ReadOnly))
        return;
    const QList<QByteArray> lines = log.readAll().split('\n');
    for (const QByteArray& line : lines.mid(std::max<qsizetype>(0, lines.size() - kLinesOfLog)))
        std::fprintf(stderr, "  %s\n", line.constData());
}

/// Aborts the process if the window does not return from an action, so that a debugger or the sanitizer shows
/// where it is.
class Watchdog {
public:
    explicit Watchdog(QString log)
        : m_log(std::move(log)), m_thread([this](const std::stop_token& stop) { watch(stop); }) {}
    void alive() { m_beat.fetch_add(1); }

private:
    void watch(const std::stop_token& stop) {
        std::uint64_t seen = 0;
        int gap = 0;
        while (!stop.stop_requested()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(200));
            const std::uint64_t now = m_beat.load();
            gap = now == seen ? gap + 1 : 0;
            seen = now;
            if (gap > kLongestGap * 5) {
                std::fprintf(stderr, "The window has not answered for %d s; the last actions:\n",
                             kLongestGap);
                printEndOfLog(m_log);
                std::abort();
            }
        }
    }

    QString m_log;
    std::atomic<std::uint64_t> m_beat{0};
    std::jthread m_thread;
};

} // namespace

class MonkeyTest : public QObject {
    Q_OBJECT

private slots:
    void randomInputFindsNothing() {
        const OwnSettings settings;
        const std::uint32_t seed = randomSeed();
        const QTemporaryDir folder;
        Monkey monkey(seed, folder.path());
        std::fprintf(stderr, "PROVEOUT_SEED=%u, log in %s\n", seed, qPrintable(monkey.logFile()));
        Watchdog watchdog(monkey.logFile());
        QElapsedTimer clock;
        clock.start();
        const qint64 end = qint64{1000} * secondsOfMonkey();
        while (clock.elapsed() < end) {
            monkey.act();
            watchdog.alive();
            const QString fault = monkey.fault();
            if (!fault.isEmpty()) {
                printEndOfLog(monkey.logFile());
                QFAIL(qPrintable(QStringLiteral("%1 after %2 actions of seed %3")
                                     .arg(fault)
                                     .arg(monkey.actions())
                                     .arg(seed)));
            }
        }
        std::fprintf(stderr, "%llu actions\n", static_cast<unsigned long long>(monkey.actions()));
        QVERIFY(monkey.actions() > 0);
    }
};

} // namespace proveout

int main(int argc, char** argv) {
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    QApplication::setQuitOnLastWindowClosed(false); // the monkey closes windows
    // Qt Test aborts a function after five minutes, whether the window responds or not.
    qputenv("QTEST_FUNCTION_TIMEOUT", QByteArray::number(1000 * (proveout::secondsOfMonkey() + 600)));
    proveout::MonkeyTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "monkey_test.moc"
