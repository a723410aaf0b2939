// SPDX-License-Identifier: GPL-3.0-or-later
// Loops on several threads. All parallel loops of the core go through here, because ThreadSanitizer does not
// see the synchronisation of oneTBB: parallel.cpp tells it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace proveout {

namespace parallel_detail {
using Work = void (*)(const void* body, std::size_t first, std::size_t last);
void run(std::size_t count, std::size_t grain, Work work, const void* body);
void runApart(void (*work)(const void* body), const void* body);
void runOnThisThread(void (*work)(const void* body), const void* body);
} // namespace parallel_detail

/// Calls `body(first, last)` for ranges that together are [0, count), several at once, and returns when all
/// have returned. Ranges of up to `grain` numbers are not divided. What was written before the
/// call is seen by each of them, and what they write is seen after it. An exception of the body is thrown
/// again here; other ranges may not have been called then.
template<class Body>
void inParallelRanges(std::size_t count, std::size_t grain, const Body& body) {
    parallel_detail::run(
        count, grain,
        [](const void* work, std::size_t first, std::size_t last) {
            (*static_cast<const Body*>(work))(first, last);
        },
        &body);
}

/// The same with `body(k)` for each k below `count`.
template<class Body>
void inParallel(std::size_t count, const Body& body) {
    inParallelRanges(count, 1, [&body](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k)
            body(k);
    });
}

/// Calls `body()`. While loops within it wait for other threads, this thread takes on nothing from outside of
/// it, so that its time is that of its own work.
template<class Body>
void apart(const Body& body) {
    parallel_detail::runApart([](const void* work) { (*static_cast<const Body*>(work))(); }, &body);
}

/// Calls `body()`. Loops within it use this thread alone, whatever its priority is.
template<class Body>
void onThisThread(const Body& body) {
    parallel_detail::runOnThisThread([](const void* work) { (*static_cast<const Body*>(work))(); }, &body);
}

/// The largest of `valueOf(k)` for all k below `count`; at least 0. `valuesOfTask` are found one after the
/// other.
template<class ValueOf>
double largestInParallel(std::size_t count, std::size_t valuesOfTask, const ValueOf& valueOf) {
    std::vector<double> largest((count + valuesOfTask - 1) / valuesOfTask, 0.0);
    inParallel(largest.size(), [&](std::size_t task) {
        const std::size_t first = task * valuesOfTask;
        for (std::size_t k = first; k < std::min(first + valuesOfTask, count); ++k)
            largest[task] = std::max<double>(largest[task], valueOf(k));
    });
    return largest.empty() ? 0 : *std::ranges::max_element(largest);
}

} // namespace proveout
