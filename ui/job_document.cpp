// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/job_document.h"

#include <utility>

#include "core/decimation/region_decimator.h"
#include "core/formats/job_file.h"
#include "ui/file_paths.h"

namespace proveout {

namespace {

bool isJobFile(const QString& file) {
    return file.endsWith(QLatin1String(".proveout"), Qt::CaseInsensitive);
}

} // namespace

Result<Document> JobDocument::readText(const std::filesystem::path& file, const WorkContext& context) {
    Result<Document> text = loadDocument(file, context);
    if (!text) {
        // A place in a text that is not open would be shown in the one that is.
        for (Diagnostic& error : text.error())
            error.where = {};
    }
    return text;
}

Result<JobDocument> JobDocument::open(const QString& file, const WorkContext& context) {
    JobDocument document;
    std::filesystem::path program = toPath(file);
    if (isJobFile(file)) {
        Result<Job> job = readJob(program);
        if (!job)
            return tl::unexpected(std::move(job.error()));
        program = std::move(job->program);
        document.m_jobFile = file;
        document.m_warnings = std::move(job->warnings);
        document.m_wantsStock = false;
        document.m_setup = std::make_shared<const Setup>(std::move(job->setup));
        document.m_parameters = job->parameters;
        document.m_machine = job->machine;
        document.m_regionNamed = job->regionNamed;
    }
    Result<Document> text = readText(program, context);
    if (!text)
        return tl::unexpected(std::move(text.error()));
    document.m_text = std::move(*text);
    return document;
}

Result<void> JobDocument::save() {
    if (m_text.modified) {
        if (Result<void> written = saveTextAs(toQString(m_text.path)); !written)
            return written;
    }
    return m_jobModified && !m_jobFile.isEmpty() ? saveJobAs(m_jobFile) : Result<void>();
}

Result<void> JobDocument::saveTextAs(const QString& file) {
    std::filesystem::path path = toPath(file);
    if (Result<void> written = saveDocument(m_text, path); !written)
        return written;
    if (path != m_text.path && !m_jobFile.isEmpty())
        m_jobModified = true; // the job must name the new program
    m_text.path = std::move(path);
    m_text.modified = false;
    m_keptMine = false;
    return {};
}

Result<void> JobDocument::saveJobAs(const QString& file) {
    const Job job{std::filesystem::absolute(m_text.path), *m_setup, m_parameters, m_machine};
    if (Result<void> written = writeJob(toPath(file), job); !written)
        return written;
    m_jobFile = file;
    m_jobModified = false;
    return {};
}

void JobDocument::replaceText(Document text) {
    m_text = std::move(text);
    m_keptMine = false;
}

void JobDocument::edit(std::size_t offset, std::size_t removed, std::string_view inserted) {
    m_text.text = m_text.text.replaced(offset, removed, inserted);
}

void JobDocument::keepMine() {
    m_keptMine = true;
    m_text.modified = true;
}

bool JobDocument::setTextModified(bool modified) {
    const bool before = std::exchange(m_text.modified, modified || m_keptMine);
    return before != m_text.modified;
}

/// What nobody has set up yet has an automatic grid.
std::shared_ptr<const Setup> JobDocument::newSetup() {
    Setup setup;
    setup.automaticGrid = true;
    return std::make_shared<const Setup>(std::move(setup));
}

int JobDocument::standardRegionHere(DecimationMethod method) const {
    return standardRegion(method, gridPoints(m_setup->stock, m_setup->spacing));
}

void JobDocument::setSetup(std::shared_ptr<const Setup> setup) {
    fitSetup(std::move(setup));
    m_jobModified = true;
}

void JobDocument::fitSetup(std::shared_ptr<const Setup> setup, bool forNow) {
    m_setup = std::move(setup);
    m_wantsStock = m_wantsStock && forNow;
    if (!m_regionNamed)
        m_parameters.regionCells = standardRegionHere(m_parameters.method);
}

void JobDocument::setParameters(const DecimationParameters& parameters) {
    if (parameters.regionCells != m_parameters.regionCells || parameters.method != m_parameters.method)
        m_regionNamed = parameters.regionCells != standardRegionHere(parameters.method);
    m_parameters = parameters;
    m_jobModified = m_jobModified || !m_jobFile.isEmpty();
}

void JobDocument::setMachine(const Machine& machine) {
    m_machine = machine;
    m_jobModified = true;
}

} // namespace proveout
