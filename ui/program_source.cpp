// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/program_source.h"

#include <exception>
#include <new>
#include <utility>

#include <QMetaObject>

#include "core/base/text.h"

namespace proveout {

namespace {

ProgramSource::Interpret resuming() {
    return [interpreter = std::make_shared<ResumableInterpreter>()](
               const NcText& text, const InterpretOptions& options, const WorkContext& context,
               const ResumableInterpreter::Publish& publish) {
        return interpreter->interpret(text, options, context, publish);
    };
}

} // namespace

ProgramSource::ProgramSource(QObject* parent, Interpret interpret)
    : QObject(parent), m_interpret(interpret ? std::move(interpret) : resuming()),
      m_thread([this](const std::stop_token& stop) { run(stop); }) {}

ProgramSource::~ProgramSource() {
    m_current.request_stop();
    m_thread.request_stop();
    m_thread.join();
}

void ProgramSource::request(NcText text, InterpretOptions options, bool beginning) {
    cancel();
    {
        const std::scoped_lock lock(m_mutex);
        m_waiting =
            Request{std::move(text), std::move(options), beginning, m_generation, m_current.get_token()};
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

void ProgramSource::stop() {
    m_current.request_stop();
}

/// Has something told on the UI thread, unless nobody wants to know any more.
template<typename Tell>
void ProgramSource::post(std::uint64_t generation, Tell tell) {
    QMetaObject::invokeMethod(
        this,
        [this, generation, tell = std::move(tell)] {
            if (generation == m_generation)
                tell();
        },
        Qt::QueuedConnection);
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
        post(request.generation, [this, result = carryOut(request)] {
            if (result)
                emit ready(*result);
            else
                emit failed(result.error());
        });
    }
}

Result<std::shared_ptr<const Program>> ProgramSource::carryOut(const Request& request) {
    try {
        WorkContext context;
        context.stop = request.stop;
        context.progress = [this, &request](double done) {
            if (done > 0 && done < 1)
                post(request.generation, [this, done] { emit progressed(done); });
        };
        ResumableInterpreter::Publish publish;
        if (request.beginning)
            publish = [this, &request](const std::shared_ptr<const Program>& program) {
                post(request.generation, [this, program] { emit begun(program); });
            };
        return m_interpret(request.text, request.options, context, publish);
    } catch (const std::bad_alloc&) {
        return failure(
            "out-of-memory",
            PROVEOUT_TEXT("Core", "The program needs more memory to be interpreted than there is."));
    } catch (const std::exception& exception) {
        return failure("internal-error", PROVEOUT_TEXT("Core", "The interpretation had to stop: {}."),
                       {exception.what()});
    }
}

} // namespace proveout
