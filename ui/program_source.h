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

namespace proveout {

/// Interprets texts on its own thread; the newest request wins: it stops the one under way, whose result is
/// dropped. Thread: the UI thread, which also gets `ready`.
class ProgramSource : public QObject {
    Q_OBJECT

public:
    using Interpret = std::function<std::shared_ptr<const Program>(const NcText&, const InterpretOptions&,
                                                                   const WorkContext&)>;
    /// `interpret` is called on the thread; what it throws is told by `failed`.
    explicit ProgramSource(QObject* parent = nullptr, Interpret interpret = proveout::interpret);
    ~ProgramSource() override;

    void request(NcText text, InterpretOptions options);
    /// Forgets what is under way.
    void cancel();

signals:
    void ready(const std::shared_ptr<const Program>& program);
    void failed(const Diagnostics& errors);

private:
    struct Request {
        NcText text;
        InterpretOptions options;
        std::uint64_t generation = 0;
        std::stop_token stop;
    };
    void run(const std::stop_token& stop);
    [[nodiscard]] Result<std::shared_ptr<const Program>> carryOut(const Request& request) const;
    void deliver(const Result<std::shared_ptr<const Program>>& result, std::uint64_t generation);

    Interpret m_interpret;
    std::mutex m_mutex;
    std::condition_variable_any m_wake;
    std::optional<Request> m_waiting; ///< guarded by m_mutex
    std::stop_source m_current;       ///< of the newest request; UI thread
    std::uint64_t m_generation = 0;   ///< UI thread
    std::jthread m_thread;
};

} // namespace proveout
