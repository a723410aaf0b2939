// SPDX-License-Identifier: GPL-3.0-or-later
// Without the instrumentation of ThreadSanitizer (core/base/CMakeLists.txt): it does not see how oneTBB hands
// tasks to other threads, and would report each one. What the tasks do is compiled elsewhere, with it.
#include "core/base/parallel.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#ifdef PROVEOUT_THREAD_SANITIZER
extern "C" {
void __tsan_acquire(void* address); // NOLINT(bugprone-reserved-identifier): of the sanitizer's interface
void __tsan_release(void* address); // NOLINT(bugprone-reserved-identifier)
}
#endif

namespace proveout::parallel_detail {

namespace {

/// Tells ThreadSanitizer that one thread waits for another here; nothing without it.
class HandOver {
public:
    void give() {
#ifdef PROVEOUT_THREAD_SANITIZER
        __tsan_release(&m_place);
#endif
    }
    void take() {
#ifdef PROVEOUT_THREAD_SANITIZER
        __tsan_acquire(&m_place);
#endif
    }

private:
    [[maybe_unused]] char m_place = 0; ///< only its address counts
};

} // namespace

void run(std::size_t count, std::size_t grain, Work work, const void* body) {
    HandOver begin;
    HandOver end;
    begin.give();
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain), [&](const auto& range) {
        begin.take();
        work(body, range.begin(), range.end());
        end.give();
    });
    end.take();
}

void runApart(void (*work)(const void* body), const void* body) {
    tbb::this_task_arena::isolate([&] { work(body); });
}

void runOnThisThread(void (*work)(const void* body), const void* body) {
    tbb::task_arena alone(1); // its only place is for the caller
    alone.execute([&] { work(body); });
}

} // namespace proveout::parallel_detail
