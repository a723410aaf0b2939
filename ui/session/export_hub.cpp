// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/export_hub.h"

#include <memory>
#include <utility>

#include "core/verification/findings/window_findings.h"
#include "ui/session/document_hub.h"
#include "ui/session/problems_hub.h"
#include "ui/session/program_hub.h"
#include "ui/session/simulation_hub.h"
#include "ui/session/work_hub.h"

namespace proveout {

ExportHub::ExportHub(const Hubs& hubs) : m_hubs(hubs) {
    hubs.work.setCancel(WorkKind::exporting, [this] { m_export.cancel(); });
    connect(&m_export, &ExportJob::progressed, this, [this](double done) {
        if (m_running)
            m_hubs.work.set(WorkKind::exporting, done);
    });
}

void ExportHub::exportMesh(const QString& file, const ExportOptions& options) {
    m_hubs.simulation.takeFrame();
    exportFrame(file, options);
}

void ExportHub::exportFrame(const QString& file, const ExportOptions& options) {
    if (m_running) {
        m_hubs.problems.report(failure(window_finding::kExportRunning).value());
        return;
    }
    if (!m_hubs.simulation.frame()) {
        m_hubs.problems.report(failure(window_finding::kNoStock).value());
        return;
    }
    m_hubs.problems.set(ProblemSource::files, {});
    m_running = true;
    m_hubs.work.set(WorkKind::exporting, 0);
    // The parameters of the frame may be those of playback, which can suspend decimation; the file uses those
    // that the user wants.
    auto moment = std::make_shared<Frame>(*m_hubs.simulation.frame());
    moment->parameters = m_hubs.document.job().parameters();
    m_export.start(std::move(moment), file, options,
                   [this](const Result<ExportSummary>& result) { finish(result); });
}

void ExportHub::saveStock(const QString& file) {
    m_hubs.simulation.takeFrame();
    ExportOptions options{.format = findFormat("stock")};
    options.provenance.program = m_hubs.document.text().path.filename().string();
    if (const FramePtr& frame = m_hubs.simulation.frame()) {
        options.provenance.blocks = frame->block;
        options.provenance.line = frame->block > 0 ? frame->program->blockLine(frame->block - 1) : 0;
        options.provenance.finished =
            frame->block == frame->program->blockCount() && !m_hubs.program.isReading();
    }
    exportFrame(file, options); // what is written about the stock belongs to this frame
}

void ExportHub::finish(const Result<ExportSummary>& result) {
    m_running = false;
    m_hubs.work.set(WorkKind::exporting, {});
    if (!result) {
        m_hubs.problems.report(result.error());
        return;
    }
    m_last = *result;
    m_hubs.problems.add(result->warnings);
    emit exported(*result);
}

} // namespace proveout
