// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

#include <CLI/CLI.hpp>

namespace proveout::cli {

/// `--threads N`: the number of threads that work in parallel; results never depend on it.
class ThreadLimit {
public:
    ThreadLimit();
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

    /// This object must outlive the parsing.
    void addTo(CLI::App& command);
    /// Limits the threads from this call until this object is destroyed.
    void apply();
    /// The same with another number.
    void apply(int threads);
    /// The number of threads that work in parallel now.
    [[nodiscard]] static std::size_t threads();

private:
    int m_threads = 0;
    struct Control;
    std::unique_ptr<Control> m_control;
};

} // namespace proveout::cli
