// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include <QtTest>

#include "ui/work/newest_task.h"
#include "ui/work/ui_queue.h"

using namespace proveout;

namespace {

constexpr int kPatience = 10'000;

} // namespace

/// Also run under ThreadSanitizer: the data passed are plain values, and only the queue synchronises them.
class UiQueueTest : public QObject {
    Q_OBJECT

private slots:
    void callsOfAThreadAreMadeInTheirOrder() {
        constexpr int kCalls = 1000;
        constexpr int kThreads = 4;
        UiQueue queue;
        std::vector<std::vector<int>> seen(kThreads);
        int made = 0;
        {
            std::vector<std::jthread> threads;
            for (int thread = 0; thread < kThreads; ++thread)
                threads.emplace_back([&, thread] {
                    for (int call = 0; call < kCalls; ++call)
                        queue.post([&, thread, call, payload = std::vector<int>{call}] {
                            QCOMPARE(payload, std::vector<int>{call});
                            seen[static_cast<std::size_t>(thread)].push_back(call);
                            ++made;
                        });
                });
        }
        QTRY_COMPARE_WITH_TIMEOUT(made, kThreads * kCalls, kPatience);
        for (const std::vector<int>& calls : seen)
            for (std::size_t i = 0; i < calls.size(); ++i)
                QCOMPARE(calls[i], static_cast<int>(i));
    }

    void callsAreMadeOnItsOwnThreadOnly() {
        UiQueue queue;
        std::atomic<bool> made = false;
        std::jthread([&] { queue.post([&] { made = QThread::currentThread() == queue.thread(); }); }).join();
        QVERIFY(!made);
        QTRY_VERIFY_WITH_TIMEOUT(made, kPatience);
    }

    void aQueueThatIsGoneDropsItsCalls() {
        bool made = false;
        {
            UiQueue queue;
            queue.post([&] { made = true; });
        }
        QCoreApplication::processEvents();
        QVERIFY(!made);
    }

    void aCallMayDestroyTheQueue() {
        auto queue = std::make_unique<UiQueue>();
        bool madeAfterwards = false;
        queue->post([&] { queue.reset(); });
        queue->post([&] { madeAfterwards = true; });
        QTRY_VERIFY_WITH_TIMEOUT(queue == nullptr, kPatience);
        QCoreApplication::processEvents();
        QVERIFY(!madeAfterwards);
    }

    void onlyTheNewestTaskAnswers() {
        NewestTask task;
        std::vector<int> answers;
        for (int number = 0; number < 50; ++number)
            task.start([&answers, number](const NewestTask::Reply& reply) {
                reply.post([&answers, number, payload = std::vector<int>(100, number)] {
                    QCOMPARE(payload.back(), number);
                    answers.push_back(number);
                });
            });
        QTRY_COMPARE_WITH_TIMEOUT(answers, std::vector<int>{49}, kPatience);
    }
};

QTEST_GUILESS_MAIN(UiQueueTest)
#include "ui_queue_test.moc"
