// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/program_source.h"

#include <exception>
#include <new>
#include <utility>

#include <QMetaObject>

#include "core/base/text.h"

namespace proveout {

ProgramSource::ProgramSource(QObject* parent, Interpret interpret)
    : QObject(parent), m_interpret(std::move(interpret)),
      m_thread([this](const std::stop_token& stop) { run(stop); }) {}

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
        QMetaObject::invokeMethod(
            this,
            [this, result = carryOut(request), generation = request.generation] {
                deliver(result, generation);
            },
            Qt::QueuedConnection);
    }
}

Result<std::shared_ptr<const Program>> ProgramSource::carryOut(const Request& request) const {
    try {
        WorkContext context;
        context.stop = request.stop;
        return m_interpret(request.text, request.options, context);
    } catch (const std::bad_alloc&) {
        return failure(
            "out-of-memory",
            PROVEOUT_TEXT("Core", "The program needs more memory to be interpreted than there is."));
    } catch (const std::exception& exception) {
        return failure("internal-error", PROVEOUT_TEXT("Core", "The interpretation had to stop: {}."),
                       {exception.what()});
    }
}

void ProgramSource::deliver(const Result<std::shared_ptr<const Program>>& result, std::uint64_t generation) {
    if (generation != m_generation)
        return;
    if (result)
        emit ready(*result);
    else
        emit failed(result.error());
}

} // namespace proveout
