// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/program_source.h"

#include <utility>

#include <QMetaObject>

namespace proveout {

ProgramSource::ProgramSource(QObject* parent)
    : QObject(parent), m_thread([this](const std::stop_token& stop) { run(stop); }) {}

ProgramSource::~ProgramSource() {
    m_current.request_stop();
    m_thread.request_stop();
    m_thread.join();
}

void ProgramSource::request(NcText text, InterpretOptions options) {
    cancel();
    {
        const std::scoped_lock lock(m_mutex);
        m_waiting = Request{std::move(text), std::move(options), m_generation, m_current.get_token()};
    }
    m_wake.notify_one();
}

void ProgramSource::cancel() {
    m_current.request_stop();
    m_current = std::stop_source();
    ++m_generation;
    const std::scoped_lock lock(m_mutex);
    m_waiting.reset();
}

void ProgramSource::run(const std::stop_token& stop) {
    while (true) {
        Request request;
        {
            std::unique_lock lock(m_mutex);
            if (!m_wake.wait(lock, stop, [this] { return m_waiting.has_value(); }))
                return;
            request = std::move(*m_waiting);
            m_waiting.reset();
        }
        WorkContext context;
        context.stop = request.stop;
        const std::shared_ptr<const Program> program = interpret(request.text, request.options, context);
        QMetaObject::invokeMethod(
            this, [this, program, generation = request.generation] { deliver(program, generation); },
            Qt::QueuedConnection);
    }
}

void ProgramSource::deliver(const std::shared_ptr<const Program>& program, std::uint64_t generation) {
    if (generation == m_generation)
        emit ready(program);
}

} // namespace proveout
