// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/program/program_source.h"

#include <exception>
#include <new>
#include <utility>

#include "core/simulation/run/interpretation.h"
#include "core/verification/findings/window_findings.h"

namespace proveout {

namespace {

ProgramSource::Interpret resuming() {
    return [interpreter = std::make_shared<ResumableInterpreter>()](
               const NcText& text, const InterpretOptions& options, const WorkContext& context,
               const PublishBeginning& publish) {
        return interpreter->interpret(text, options, context, publish);
    };
}

} // namespace

ProgramSource::ProgramSource(QObject* parent, Interpret interpret)
    : QObject(parent), m_interpret(interpret ? interpret : resuming()),
      m_interpretAssuming(interpret ? std::move(interpret) : resuming()) {}

void ProgramSource::request(NcText text, InterpretOptions options, bool beginning,
                            std::optional<KnownTools> known) {
    m_task.start([this, request = Request{std::move(text), std::move(options), beginning, std::move(known)}](
                     const Reply& reply) {
        reply.post([this, result = carryOut(request, reply)] {
            if (result)
                emit ready(result->program, result->cutting);
            else
                emit failed(result.error());
        });
    });
}

ToolTable ProgramSource::toolsOf(const Request& request, const Reply& reply) {
    const ToolProposals proposals = proposeTools(request.text);
    reply.post([this, proposals] { emit proposed(proposals); });
    ToolTable tools = request.known->tools;
    addProposals(tools, proposals, request.known->proposed);
    return tools;
}

std::shared_ptr<const Program> ProgramSource::interpret(const Request& request, const Reply& reply) {
    WorkContext context;
    context.stop = reply.stop;
    context.progress = [this, &reply](double done) {
        if (done > 0 && done < 1)
            reply.post([this, done] { emit progressed(done); });
    };
    PublishBeginning publish;
    if (request.beginning)
        publish = [this, &reply](const std::shared_ptr<const Program>& program) {
            reply.post([this, program, cutting = cuttingExtent(*program)] { emit begun(program, cutting); });
        };
    if (!request.known)
        return m_interpret(request.text, request.options, context, publish);
    const ToolTable tools = toolsOf(request, reply);
    InterpretOptions options = request.options;
    options.tools = toolOffsets(tools);
    auto program = m_interpret(request.text, options, context, publish);
    if (request.known->startToolKnown || context.stopped())
        return program;
    return withAssumedTool(std::move(program), options, tools, [&](const InterpretOptions& assuming) {
        return m_interpretAssuming(request.text, assuming, context, {});
    });
}

Result<ProgramSource::Interpreted> ProgramSource::carryOut(const Request& request, const Reply& reply) {
    try {
        const auto program = interpret(request, reply);
        const bool watching = request.options.watchedLine > 0;
        return Interpreted{program, watching ? CuttingExtent() : cuttingExtent(*program)};
    } catch (const std::bad_alloc&) {
        return failure(window_finding::kInterpretingOutOfMemory);
    } catch (const std::exception& exception) {
        return failure(window_finding::kInterpretingFailed, {exception.what()});
    }
}

} // namespace proveout
