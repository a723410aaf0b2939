// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run/program_reading.h"

#include <algorithm>
#include <utility>

#include "core/base/stop_watch.h"
#include "core/simulation/run/interpretation.h"

namespace proveout {

ProgramReading::ProgramReading(Setup setup, NcText text, InterpretOptions options)
    : m_setup(std::move(setup)), m_text(std::move(text)), m_options(std::move(options)),
      m_textBytes(m_text.size()), m_lines(m_text.lineCount()),
      m_thread([this](const std::stop_token& stop) { read(stop); }) {}

ProgramReading::~ProgramReading() = default;

std::shared_ptr<const Program> ProgramReading::next() {
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [this] { return m_newest || m_ended; });
    m_whole = m_ended;
    if (m_error)
        std::rethrow_exception(m_error);
    return std::exchange(m_newest, nullptr);
}

double ProgramReading::partOf(const Program& program) const {
    if (m_whole || m_lines == 0)
        return 1;
    const auto read = static_cast<double>(std::max<std::size_t>(program.sourceBlockCount(), 1));
    return std::min(read / static_cast<double>(m_lines), 1.0);
}

void ProgramReading::read(const std::stop_token& stop) {
    const StopWatch watch;
    std::shared_ptr<const Program> whole;
    std::exception_ptr error;
    try {
        whole = interpretAll(stop);
    } catch (...) {
        error = std::current_exception();
    }
    m_text = NcText();
    const std::lock_guard lock(m_mutex);
    m_newest = std::move(whole);
    m_error = error;
    m_seconds = watch.seconds();
    m_ended = true;
    m_changed.notify_one();
}

std::shared_ptr<const Program> ProgramReading::interpretAll(const std::stop_token& stop) {
    const WorkContext context{stop, {}};
    const auto again = [&](const InterpretOptions& options) {
        return interpret(m_text, options, context, [this](const auto& beginning) { offer(beginning); });
    };
    auto program = again(m_options);
    return m_setup.startTool ? program : withAssumedTool(std::move(program), m_options, m_setup.tools, again);
}

void ProgramReading::offer(std::shared_ptr<const Program> program) {
    const std::lock_guard lock(m_mutex);
    m_newest = std::move(program);
    m_changed.notify_one();
}

} // namespace proveout
