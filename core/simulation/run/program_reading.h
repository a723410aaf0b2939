// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>

#include "core/nc/run/interpreter.h"
#include "core/simulation/setup/setup.h"

namespace proveout {

/// Interprets a program on a thread of its own, so that its beginning can be cut while the rest is read.
/// Owned by one thread, which alone calls it; its end stops the reading.
class ProgramReading {
public:
    /// Starts to read; the result is that of interpretOn().
    ProgramReading(Setup setup, NcText text, InterpretOptions options);
    ~ProgramReading();
    ProgramReading(const ProgramReading&) = delete;
    ProgramReading& operator=(const ProgramReading&) = delete;

    /// Waits for a longer beginning than the last one, or for the whole program. Programs of less than some
    /// 100,000 motions are only returned as a whole. A beginning is marked unverified; the whole program may
    /// differ from it if it turns out which tool is in the spindle (Simulation::noteProgram()). Throws what
    /// the interpreter threw, above all std::bad_alloc.
    [[nodiscard]] std::shared_ptr<const Program> next();
    /// Whether next() has returned the whole program.
    [[nodiscard]] bool isWhole() const { return m_whole; }
    /// Wall time of the thread; valid for the whole program.
    [[nodiscard]] double seconds() const { return m_seconds; }

    /// Bytes of the text, which is kept until the program is whole.
    [[nodiscard]] std::size_t textBytes() const { return m_textBytes; }
    /// The part of the text that was read for `program`, which next() returned, in (0, 1].
    [[nodiscard]] double partOf(const Program& program) const;

private:
    void read(const std::stop_token& stop);
    [[nodiscard]] std::shared_ptr<const Program> interpretAll(const std::stop_token& stop);
    void offer(std::shared_ptr<const Program> program);

    Setup m_setup;
    NcText m_text;
    InterpretOptions m_options;
    std::size_t m_textBytes;
    std::size_t m_lines;
    bool m_whole = false;

    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::shared_ptr<const Program> m_newest; ///< not taken yet
    std::exception_ptr m_error;
    bool m_ended = false;
    double m_seconds = 0; ///< written before m_ended

    std::jthread m_thread; ///< last, so that it ends before what it uses
};

} // namespace proveout
