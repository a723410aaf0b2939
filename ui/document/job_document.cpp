// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/job_document.h"

#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/folder_lock.h"
#include "core/base/text.h"
#include "core/decimation/regions/region_decimator.h"
#include "core/verification/findings/window_findings.h"
#include "ui/document/carried_values.h"
#include "ui/document/file_paths.h"

namespace proveout {

namespace {

/// bytes; larger changed files cannot be compared
constexpr std::uint64_t kLargestShown = 64'000'000;

bool isJobFile(const QString& file) {
    return file.endsWith(QLatin1String(".proveout"), Qt::CaseInsensitive);
}

/// A file that cannot be read counts as no file, so a save treats any content it finds there as foreign.
DiskCopy copyOf(const std::filesystem::path& file) {
    return DiskCopy::read(file, kLargestShown).value_or(DiskCopy());
}

DiskCopy copyOf(const Document& text) {
    return {text.text, text.byteOrderMark};
}

/// What the file contains, if it still has this digest; otherwise no file.
DiskCopy copyWith(const std::string& digest, const std::filesystem::path& file) {
    DiskCopy now = DiskCopy::read(file, kEditableBytes).value_or(DiskCopy());
    return !digest.empty() && now.digest() == digest ? now : DiskCopy();
}

Result<void> withHint(Result<void> result) {
    if (result)
        return result;
    for (Diagnostic& error : result.error())
        if (*error.hint == '\0')
            error.hint = PROVEOUT_TEXT("Core", "Save under another name (File > Save As).");
    return result;
}

/// The spacing of an automatic grid is determined again for every program and does not count as a change by
/// the user.
bool isSameSetup(const Setup& a, const Setup& b) {
    if (!a.automaticGrid || !b.automaticGrid || a.spacing == b.spacing)
        return a == b;
    Setup other = b;
    other.spacing = a.spacing;
    return a == other;
}

} // namespace

Result<std::filesystem::path> JobDocument::readSetup(const std::filesystem::path& file,
                                                     const OutsideRule& allowed) {
    m_jobState = stateOf(file); // taken first, so that a change during reading is reported
    m_jobOnDisk = copyOf(file);
    Result<Job> job = readJob(file, allowed);
    if (!job)
        return tl::unexpected(std::move(job.error()));
    m_warnings = std::move(job->warnings);
    m_values.wantsStock = false;
    m_values.setup = std::make_shared<const Setup>(std::move(job->setup));
    m_values.parameters = job->parameters;
    m_values.machine = job->machine;
    m_values.check = std::move(job->check);
    m_values.part = std::move(job->part);
    m_values.regionNamed = job->regionNamed;
    jobSaved();
    return std::move(job->program);
}

Result<JobDocument> JobDocument::open(const QString& file, const WorkContext& context,
                                      const OutsideRule& allowed) {
    JobDocument document;
    std::filesystem::path program = toPath(file);
    if (isJobFile(file)) {
        Result<std::filesystem::path> named = document.readSetup(program, allowed);
        if (!named)
            return tl::unexpected(std::move(named.error()));
        program = std::move(*named);
        document.m_jobFile = file;
    }
    Result<Document> text = loadClosedDocument(program, context);
    if (!text)
        return tl::unexpected(std::move(text.error()));
    document.m_text = std::move(*text);
    document.m_textOnDisk = copyOf(document.m_text);
    return document;
}

Result<JobDocument> JobDocument::restore(const KeptWork& kept, const WorkContext& context) {
    JobDocument document;
    if (!kept.keptJob.empty()) {
        // The text does not depend on errors in the setup, e.g. a missing stock file. Any outside file is
        // allowed, because the window had this job open before.
        if (auto named = document.readSetup(kept.keptJob, anyOutside); !named)
            document.m_warnings = std::move(named.error());
    }
    Result<Document> text = loadClosedDocument(kept.keptText.empty() ? kept.program : kept.keptText, context);
    if (!text)
        return tl::unexpected(std::move(text.error()));
    document.m_text = std::move(*text);
    if (kept.keptText.empty()) {
        document.m_textOnDisk = copyOf(document.m_text);
    } else {
        document.m_text.path = kept.program;
        document.m_text.onDisk = stateOf(kept.program);
        document.m_textOnDisk = copyWith(kept.programDigest, kept.program);
        document.keepMine();
    }
    document.m_jobFile = kept.jobFile;
    if (kept.jobModified) {
        document.m_jobState = stateOf(toPath(kept.jobFile));
        document.m_jobOnDisk = copyWith(kept.jobDigest, toPath(kept.jobFile));
        document.m_jobOutdated = true;
    }
    return document;
}

Job JobDocument::job() const {
    const std::filesystem::path program =
        m_text.path.empty() ? std::filesystem::path() : std::filesystem::absolute(m_text.path);
    return {program, *m_values.setup, m_values.parameters, m_values.machine, m_values.check, m_values.part};
}

/// Changed parameters alone do not require a job file.
bool JobDocument::jobModified() const {
    return m_jobOutdated || !isSameSetup(*m_values.setup, *m_saved.setup) ||
           m_values.machine != m_saved.machine || m_values.check != m_saved.check ||
           m_values.part != m_saved.part ||
           (!m_jobFile.isEmpty() && !(m_values.parameters == m_saved.parameters));
}

bool JobDocument::toolsModified() const {
    return !(m_values.setup->tools == m_saved.setup->tools);
}

void JobDocument::jobSaved() {
    m_saved = m_values;
    m_jobOutdated = false;
    ++m_jobSaves;
    ++m_revision;
}

std::filesystem::path JobDocument::pathOf(FilePart part) const {
    return part == FilePart::text ? m_text.path : toPath(m_jobFile);
}

DiskCopy JobDocument::mine(FilePart part) const {
    if (part == FilePart::text)
        return copyOf(m_text);
    return {NcText(jobText(toPath(m_jobFile), job()).value_or(std::string())), false};
}

Result<DiskState> JobDocument::diskState(FilePart part) const {
    const std::filesystem::path file = pathOf(part);
    Result<DiskState> state = (part == FilePart::text ? m_textOnDisk : m_jobOnDisk).compare(file);
    if (state && *state == DiskState::changed)
        state = mine(part).compare(file);
    return state;
}

std::optional<DiskConflict> JobDocument::conflict(FilePart part) const {
    const std::filesystem::path file = pathOf(part);
    if (file.empty())
        return std::nullopt;
    const Result<DiskState> state = diskState(part);
    if (!state || *state != DiskState::changed)
        return std::nullopt;                 // the save reports that the file cannot be read
    const FileState present = stateOf(file); // taken first, so that a change during saving is noticed
    return DiskConflict{part, file, mine(part).text(), copyOf(file), present};
}

Result<void> JobDocument::mayReplace(FilePart part) const {
    const std::filesystem::path file = pathOf(part);
    const Result<DiskState> state = diskState(part);
    if (!state)
        return tl::unexpected(state.error());
    if (*state == DiskState::changed)
        return failure(window_finding::kFileChangedOnDisk, {}, file.string());
    return {};
}

void JobDocument::acceptDisk(const DiskConflict& conflict) {
    (conflict.part == FilePart::text ? m_textOnDisk : m_jobOnDisk) =
        conflict.other.isKnown() ? conflict.other : DiskCopy(conflict.state);
}

Result<void> JobDocument::save() {
    if (m_text.modified) {
        if (Result<void> written = saveTextAs(toQString(m_text.path)); !written)
            return written;
    }
    return jobModified() && !m_jobFile.isEmpty() ? saveJobAs(m_jobFile) : Result<void>();
}

Result<void> JobDocument::saveTextAs(const QString& file) {
    std::filesystem::path path = toPath(file);
    const FolderLock turn(path.parent_path());
    if (path == m_text.path) {
        if (Result<void> may = mayReplace(FilePart::text); !may)
            return withHint(std::move(may));
    }
    if (Result<void> written = saveDocument(m_text, path); !written)
        return withHint(std::move(written));
    if (path != m_text.path && !m_jobFile.isEmpty())
        m_jobOutdated = true; // the job must name the new program
    m_text.path = std::move(path);
    m_text.modified = false;
    m_textOnDisk = copyOf(m_text);
    m_keptMine = false;
    ++m_revision;
    return {};
}

Result<void> JobDocument::saveJobAs(const QString& file) {
    const FolderLock turn(toPath(file).parent_path());
    if (file == m_jobFile) {
        if (Result<void> may = mayReplace(FilePart::job); !may)
            return withHint(std::move(may));
    }
    Result<std::string> text = jobText(toPath(file), job());
    if (!text)
        return tl::unexpected(std::move(text.error()));
    if (Result<void> written = writeFile(toPath(file), *text); !written)
        return withHint(std::move(written));
    m_jobOnDisk = {NcText(std::move(*text)), false};
    m_jobFile = file;
    jobSaved();
    return {};
}

void JobDocument::takeFiles(const JobDocument& saved) {
    const bool edited = m_textRevision != saved.m_textRevision;
    m_text.path = saved.m_text.path;
    m_textOnDisk = saved.m_textOnDisk;
    m_keptMine = saved.m_keptMine || edited;
    m_text.modified = saved.m_text.modified || edited;
    ++m_revision;
    m_jobOutdated = m_jobOutdated || saved.m_jobOutdated;
    if (saved.m_jobSaves <= m_jobSaves)
        return;
    m_jobSaves = saved.m_jobSaves;
    m_jobFile = saved.m_jobFile;
    m_jobOnDisk = saved.m_jobOnDisk;
    m_jobOutdated = false;
    m_saved = saved.m_saved;
}

void JobDocument::replaceText(Document text) {
    ++m_textRevision;
    m_text = std::move(text);
    m_textOnDisk = copyOf(m_text);
    m_keptMine = false;
    ++m_revision;
}

void JobDocument::replaceJob(const JobDocument& other) {
    m_values = other.m_values;
    m_warnings = other.m_warnings;
    m_jobOnDisk = other.m_jobOnDisk;
    m_jobState = other.m_jobState;
    m_values.wantsStock = false;
    jobSaved();
}

void JobDocument::edit(std::size_t offset, std::size_t removed, std::string_view inserted) {
    ++m_revision;
    ++m_textRevision;
    m_text.text = m_text.text.replaced(offset, removed, inserted);
}

void JobDocument::keepMine() {
    ++m_revision;
    ++m_textRevision;
    m_keptMine = true;
    m_text.modified = true;
}

void JobDocument::keepMyJob() {
    ++m_revision;
    m_jobOutdated = true;
}

bool JobDocument::setTextModified(bool modified) {
    const bool before = std::exchange(m_text.modified, modified || m_keptMine);
    return before != m_text.modified;
}

/// A setup that the user has not edited has an automatic grid.
std::shared_ptr<const Setup> JobDocument::newSetup() {
    Setup setup;
    setup.automaticGrid = true;
    return std::make_shared<const Setup>(std::move(setup));
}

int JobDocument::defaultRegionHere(DecimationMethod method) const {
    return defaultRegion(method, gridPoints(m_values.setup->stock, m_values.setup->spacing));
}

void JobDocument::setSetup(std::shared_ptr<const Setup> setup) {
    ++m_revision;
    replaceSetup(std::move(setup));
    m_values.wantsStock = false;
}

void JobDocument::fitSetup(std::shared_ptr<const Setup> setup, bool forNow) {
    const std::shared_ptr<const Setup> before = m_values.setup;
    replaceSetup(std::move(setup));
    m_values.wantsStock = m_values.wantsStock && forNow;
    // Changes by the user stay marked as unsaved.
    const bool saved = isSameSetup(*before, *m_saved.setup);
    m_saved.setup = saved ? m_values.setup
                          : std::make_shared<const Setup>(
                                carried(*m_saved.setup, *before, *m_values.setup, Carry::whereSame));
}

void JobDocument::replaceSetup(std::shared_ptr<const Setup> setup) {
    m_values.setup = std::move(setup);
    if (!m_values.regionNamed)
        m_values.parameters.regionCells = defaultRegionHere(m_values.parameters.method);
}

bool JobDocument::stockFitted() const {
    return m_jobFile.isEmpty() && m_values.setup->stock == m_saved.setup->stock &&
           m_values.setup->shape == m_saved.setup->shape;
}

void JobDocument::setParameters(const DecimationParameters& parameters) {
    ++m_revision;
    if (parameters.regionCells != m_values.parameters.regionCells ||
        parameters.method != m_values.parameters.method)
        m_values.regionNamed = parameters.regionCells != defaultRegionHere(parameters.method);
    m_values.parameters = parameters;
}

void JobDocument::change(const JobValues& from, const JobValues& to) {
    ++m_revision;
    if (from.setup != to.setup) {
        m_values.setup =
            m_values.setup == from.setup
                ? to.setup
                : std::make_shared<const Setup>(carried(*m_values.setup, *from.setup, *to.setup));
        m_values.wantsStock = to.wantsStock;
    }
    if (from.parameters != to.parameters) {
        m_values.parameters = to.parameters;
        m_values.regionNamed = to.regionNamed;
    }
    if (from.machine != to.machine)
        m_values.machine = to.machine;
    if (from.check != to.check)
        m_values.check = to.check;
    if (from.part != to.part)
        m_values.part = to.part;
}

} // namespace proveout
