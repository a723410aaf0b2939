// SPDX-License-Identifier: GPL-3.0-or-later
// Interpretation in the background.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include <QObject>

#include "core/base/diagnostic.h"
#include "core/base/work_context.h"
#include "core/nc/interpreter.h"
#include "core/nc/nc_text.h"
#include "core/nc/program.h"
#include "core/nc/resumable_interpreter.h"

namespace proveout {

/// Interprets texts on its own thread, each from where it differs from the one before; the newest request
/// wins: it stops the one under way, whose result is dropped. Thread: the UI thread, which also gets the
/// signals.
class ProgramSource : public QObject {
    Q_OBJECT

public:
    using Interpret = std::function<std::shared_ptr<const Program>(
        const NcText&, const InterpretOptions&, const WorkContext&, const ResumableInterpreter::Publish&)>;
    /// `interpret` is called on the thread; what it throws is told by `failed`. None: a ResumableInterpreter.
    explicit ProgramSource(QObject* parent = nullptr, Interpret interpret = {});
    ~ProgramSource() override;

    /// `beginning`: the beginning of a long program is wanted before the rest was read.
    void request(NcText text, InterpretOptions options, bool beginning = false);
    /// Forgets what is under way.
    void cancel();
    /// What is under way is ready as far as it is.
    void stop();

signals:
    /// The beginning of a program that is still being read.
    void begun(const std::shared_ptr<const Program>& program);
    /// How far a long text is read, in [0, 1).
    void progressed(double done);
    void ready(const std::shared_ptr<const Program>& program);
    void failed(const Diagnostics& errors);

private:
    struct Request {
        NcText text;
        InterpretOptions options;
        bool beginning = false;
        std::uint64_t generation = 0;
        std::stop_token stop;
    };
    void run(const std::stop_token& stop);
    [[nodiscard]] Result<std::shared_ptr<const Program>> carryOut(const Request& request);
    template<typename Tell>
    void post(std::uint64_t generation, Tell tell);

    Interpret m_interpret;
    std::mutex m_mutex;
    std::condition_variable_any m_wake;
    std::optional<Request> m_waiting; ///< guarded by m_mutex
    std::stop_source m_current;       ///< of the newest request; UI thread
    std::uint64_t m_generation = 0;   ///< UI thread
    std::jthread m_thread;
};

} // namespace proveout
