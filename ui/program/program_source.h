// SPDX-License-Identifier: GPL-3.0-or-later
// Interprets programs in the background.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <QObject>

#include "core/base/diagnostic.h"
#include "core/base/work_context.h"
#include "core/nc/program/program.h"
#include "core/nc/run/interpreter.h"
#include "core/nc/run/resumable_interpreter.h"
#include "core/nc/text/nc_text.h"
#include "core/simulation/setup/tool_proposals.h"
#include "ui/program/program_index.h"
#include "ui/work/newest_task.h"

namespace proveout {

/// The tools of a setup, to which the comments of the program add tools. Value type.
struct KnownTools {
    ToolTable tools;
    ToolProposals proposed;      ///< found in the comments before
    bool startToolKnown = false; ///< false: a tool may be assumed to be in the spindle
};

/// Interprets texts on its own thread, each from the point where it differs from the previous one. A new
/// request stops the one in progress, whose result is dropped. Thread: the UI thread, which also receives the
/// signals.
class ProgramSource : public QObject {
    Q_OBJECT

public:
    using Interpret = std::function<std::shared_ptr<const Program>(
        const NcText&, const InterpretOptions&, const WorkContext&, const PublishBeginning&)>;
    /// `interpret` is called on the thread; exceptions are reported by `failed`. Null: a
    /// ResumableInterpreter.
    explicit ProgramSource(QObject* parent = nullptr, Interpret interpret = {});

    /// `beginning`: report the beginning of a long program before the rest is read.
    /// `known`: read the comments for tools first (proposed()); the control then knows these tools too.
    void request(NcText text, InterpretOptions options, bool beginning = false,
                 std::optional<KnownTools> known = {});
    /// Discards the request in progress.
    void cancel() { m_task.cancel(); }
    /// Ends the request in progress; ready() reports the part that was read.
    void stop() { m_task.stop(); }

signals:
    /// The tools that comments of the text describe; emitted before begun() and ready().
    void proposed(const ToolProposals& proposals);
    /// The beginning of a program that is still being read, and its cutting extent.
    void begun(const std::shared_ptr<const Program>& program, const CuttingExtent& cutting);
    /// Progress of reading a long text, in [0, 1).
    void progressed(double done);
    /// `cutting` is empty if the request watches a single line.
    void ready(const std::shared_ptr<const Program>& program, const CuttingExtent& cutting);
    void failed(const Diagnostics& errors);

private:
    using Reply = NewestTask::Reply;
    struct Request {
        NcText text;
        InterpretOptions options;
        bool beginning = false;
        std::optional<KnownTools> known;
    };
    struct Interpreted {
        std::shared_ptr<const Program> program;
        CuttingExtent cutting;
    };
    [[nodiscard]] Result<Interpreted> carryOut(const Request& request, const Reply& reply);
    [[nodiscard]] std::shared_ptr<const Program> interpret(const Request& request, const Reply& reply);
    /// The tools of the request and those that the comments add.
    [[nodiscard]] ToolTable toolsOf(const Request& request, const Reply& reply);

    // Used only on the task's thread. The second one is for programs with an assumed tool, so that each can
    // reuse what it read before.
    Interpret m_interpret;
    Interpret m_interpretAssuming;
    NewestTask m_task; ///< last member: its thread must end before what it uses is destroyed
};

} // namespace proveout
