// SPDX-License-Identifier: GPL-3.0-or-later
// Interpretation in the background.
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

/// The tools of a setup, to which the comments of the program add. Value type.
struct KnownTools {
    ToolTable tools;
    ToolProposals proposed;      ///< that were found before
    bool startToolKnown = false; ///< else one may be assumed to be in the spindle
};

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

    /// `beginning`: the beginning of a long program is wanted before the rest was read.
    /// `known`: its comments are read for tools first (proposed()), and the control knows those too.
    void request(NcText text, InterpretOptions options, bool beginning = false,
                 std::optional<KnownTools> known = {});
    /// Forgets what is under way.
    void cancel() { m_task.cancel(); }
    /// What is under way is ready as far as it is.
    void stop() { m_task.stop(); }

signals:
    /// What the comments of the text describe; comes before begun() and ready().
    void proposed(const ToolProposals& proposals);
    /// The beginning of a program that is still being read, and what it cuts.
    void begun(const std::shared_ptr<const Program>& program, const CuttingExtent& cutting);
    /// How far a long text is read, in [0, 1).
    void progressed(double done);
    /// `cutting`: empty where one line is watched.
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
    /// Those of the request with what the comments add.
    [[nodiscard]] ToolTable toolsOf(const Request& request, const Reply& reply);

    // Used on the thread of the task only. The second one is for the assumed tool, so that each of them finds
    // what it read before.
    Interpret m_interpret;
    Interpret m_interpretAssuming;
    NewestTask m_task; ///< last: its thread ends before what it uses
};

} // namespace proveout
