// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/stock_file_hub.h"

#include <new>

#include "core/formats/stock_shapes.h"
#include "core/verification/findings/window_findings.h"
#include "ui/document/file_paths.h"
#include "ui/session/job_hub.h"
#include "ui/session/problems_hub.h"

namespace proveout {

namespace {

Diagnostic changedOnDiskWarning(const std::string& file) {
    Diagnostic warning = diagnosticOf(window_finding::kStockChangedOnDisk);
    warning.file = file;
    return warning;
}

Result<StockSpec> readAgain(const Setup& setup) {
    StockSpec spec{setup.stock, setup.shape};
    try {
        if (const Result<void> done = makeStock(spec, setup.stock.corner); !done)
            return tl::unexpected(done.error());
    } catch (const std::bad_alloc&) {
        return failure(window_finding::kStockOutOfMemory);
    }
    return spec;
}

} // namespace

StockFileHub::StockFileHub(JobHub& job, ProblemsHub& problems) : m_job(job), m_problems(problems) {
    connect(&m_watch, &FileWatch::changed, this, &StockFileHub::watchedChanged);
    connect(&job, &JobHub::setupChanged, this, &StockFileHub::watch);
}

void StockFileHub::watch() {
    const StockShape& shape = m_job.setup().shape;
    if (m_watched == shape.body)
        return;
    m_watched = shape.body;
    m_reading.cancel();
    const bool fromFile = shape.body != nullptr && !shape.file.empty();
    m_watch.watch(fromFile ? toQString(shape.file) : QString(), shape.fileState);
    report(false);
}

/// The file may again match what was read.
void StockFileHub::watchedChanged() {
    const StockShape& shape = m_job.setup().shape;
    report(stateOf(shape.file) != shape.fileState);
}

void StockFileHub::report(bool changed) {
    Diagnostics problems;
    if (changed)
        problems.push_back(changedOnDiskWarning(m_job.setup().shape.file.string()));
    m_problems.set(ProblemSource::stockFile, std::move(problems));
    m_problems.refresh();
    emit changedOnDisk(changed);
}

void StockFileHub::reload() {
    m_reading.start([this, setup = m_job.setup()](const NewestTask::Reply& reply) {
        reply.post([this, spec = readAgain(setup)] {
            if (!spec)
                return m_problems.report(spec.error());
            adopt(spec->box, spec->shape);
        });
    });
}

/// Not a change of the job, which names the same file.
void StockFileHub::adopt(const StockBox& box, const StockShape& shape) {
    Setup read = m_job.setup();
    const Vec3 corner = read.stock.corner; // the user may have moved it in the meantime
    read.stock = box;
    read.stock.corner = corner;
    read.shape = shape;
    if (const Result<void> fits = m_job.adoptSetup(read); !fits)
        m_problems.report(fits.error());
}

void StockFileHub::keep() {
    report(false);
}

} // namespace proveout
