// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/thread_limit.h"

#include <tbb/global_control.h>

namespace proveout::cli {

struct ThreadLimit::Control {
    explicit Control(int threads)
        : limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)) {}
    tbb::global_control limit;
};

ThreadLimit::ThreadLimit() = default;
ThreadLimit::~ThreadLimit() = default;

void ThreadLimit::addTo(CLI::App& command) {
    command.add_option("--threads", m_threads, "Number of parallel threads (default: all)")
        ->check(CLI::Range(1, 1024).description("1 to 1024"))
        ->type_name("N");
}

std::size_t ThreadLimit::threads() {
    return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
}

void ThreadLimit::apply() {
    if (m_threads > 0)
        apply(m_threads);
}

void ThreadLimit::apply(int threads) {
    m_control = std::make_unique<Control>(threads);
}

} // namespace proveout::cli
