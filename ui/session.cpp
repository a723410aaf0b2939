// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <QFileInfo>
#include <QMetaObject>

#include "core/base/memory.h"
#include "core/base/text.h"
#include "core/formats/job_file.h"
#include "ui/file_paths.h"
#include "ui/program_index.h"

namespace proveout {

namespace {

constexpr int kEditPauseMs = 120;
constexpr int kPaperWatchdogMs = 2000;

bool isJobFile(const QString& file) {
    return file.endsWith(QLatin1String(".proveout"), Qt::CaseInsensitive);
}

/// A place in a file that is not open would be shown in the one that is.
Diagnostics aboutFiles(Diagnostics errors) {
    for (Diagnostic& error : errors)
        error.where = {};
    return errors;
}

/// What drawing one frame stands for: the sums over the blocks (first, last].
FrameStatistics frameRow(const Frame& frame, std::size_t first) {
    FrameStatistics row;
    row.firstBlock = static_cast<std::uint32_t>(first);
    row.lastBlock = static_cast<std::uint32_t>(frame.block);
    const std::size_t end = std::min(frame.block, frame.statistics.size());
    for (std::size_t k = first; k < end; ++k) {
        row.cutSeconds += frame.statistics[k].cutSeconds;
        row.decimationSeconds += frame.statistics[k].decimationSeconds;
    }
    return row;
}

} // namespace

Session::Session(QObject* parent) : QObject(parent) {
    m_paperWatchdog.setSingleShot(true);
    m_paperWatchdog.setInterval(kPaperWatchdogMs);
    connect(&m_paperWatchdog, &QTimer::timeout, this, [this] {
        if (m_frame)
            m_simulation->frameShown(m_frame->sequence);
    });
    m_editPause.setSingleShot(true);
    m_editPause.setInterval(kEditPauseMs);
    connect(&m_editPause, &QTimer::timeout, this, &Session::interpret);
    connect(&m_watch, &FileWatch::changed, this, &Session::watchedFileChanged);
    connect(&m_tick, &RepaintTick::fired, this, &Session::onTick);
    connect(&m_source, &ProgramSource::ready, this, &Session::programReady);
    connect(&m_export, &ExportJob::progressed, this, [this](double done) {
        if (m_exporting)
            setWork(Work{tr("Exporting STL"), done});
    });

    SimulationListener listener;
    listener.frameReady = [this] {
        QMetaObject::invokeMethod(&m_tick, &RepaintTick::request, Qt::QueuedConnection);
    };
    listener.progress = [this](double done) {
        QMetaObject::invokeMethod(
            this, [this, done] { simulationProgressed(done); }, Qt::QueuedConnection);
    };
    listener.failed = [this](Diagnostics errors) {
        QMetaObject::invokeMethod(
            this, [this, errors = std::move(errors)] { simulationFailed(errors); }, Qt::QueuedConnection);
    };
    m_simulation = std::make_unique<SimulationThread>(std::move(listener));
}

Session::~Session() = default;

// The document.

bool Session::openFile(const QString& file) {
    m_messages.clear();
    const bool opened = isJobFile(file) ? openJob(file) : openProgram(file);
    refreshProblems();
    if (!opened)
        emit troubled();
    return opened;
}

bool Session::openProgram(const QString& file) {
    Result<Document> document = loadDocument(toPath(file));
    if (!document) {
        m_messages = aboutFiles(document.error());
        return false;
    }
    m_fitStock = true;
    // Nothing is cut by assumption: stock, tools and tuning of the job before are not those of this program.
    m_setup = std::make_shared<const Setup>();
    m_parameters = {};
    adopt(std::move(*document), {});
    return true;
}

bool Session::openJob(const QString& file) {
    Result<Job> job = readJob(toPath(file));
    if (!job) {
        m_messages = job.error();
        return false;
    }
    Result<Document> document = loadDocument(job->program);
    if (!document) {
        m_messages = aboutFiles(document.error());
        return false;
    }
    m_fitStock = false;
    m_setup = std::make_shared<const Setup>(std::move(job->setup));
    m_parameters = job->parameters;
    adopt(std::move(*document), file);
    return true;
}

void Session::newFile() {
    m_messages.clear();
    m_fitStock = true;
    adopt(Document{}, {});
}

void Session::adopt(Document document, QString jobFile) {
    m_playback.playing = false;
    m_document = std::move(document);
    m_keptMine = false;
    m_hasDocument = true;
    m_jobFile = std::move(jobFile);
    m_jobModified = false;
    m_program.reset();
    m_loadedSetup.reset();
    ++m_generation;
    m_frame.reset();
    m_frameStatistics.clear();
    m_drawnBlock = 0;
    m_simulationErrors.clear();
    m_simulation->post(PauseCommand{});
    m_watch.watch(toQString(m_document.path));
    interpret();
    emit textReplaced();
    emit documentChanged();
    emit setupChanged();
    emit parametersChanged();
    emit playbackChanged();
    emit programChanged();
    refreshProblems();
    requestTick();
}

bool Session::save() {
    if (m_document.path.empty())
        return false;
    if (m_document.modified && !writeDocument(toQString(m_document.path)))
        return false;
    return !m_jobModified || m_jobFile.isEmpty() || writeJob(m_jobFile);
}

bool Session::saveAs(const QString& file) {
    if (!writeDocument(file))
        return false;
    if (!m_jobFile.isEmpty())
        m_jobModified = true; // the job must name the new program
    emit documentChanged();
    return true;
}

bool Session::saveJobAs(const QString& file) {
    return writeJob(file);
}

void Session::detachJob() {
    m_jobFile.clear();
    emit documentChanged();
}

bool Session::writeDocument(const QString& file) {
    m_messages.clear();
    const Result<void> written = saveDocument(m_document, toPath(file));
    if (written) {
        m_document.path = toPath(file);
        m_document.modified = false;
        m_keptMine = false;
        m_watch.watch(file);
        emit documentChanged();
    } else {
        m_messages = written.error();
    }
    refreshProblems();
    if (!written)
        emit troubled();
    return written.has_value();
}

bool Session::writeJob(const QString& file) {
    m_messages.clear();
    const Job job{std::filesystem::absolute(m_document.path), *m_setup, m_parameters};
    const Result<void> written = proveout::writeJob(toPath(file), job);
    if (written) {
        m_jobFile = file;
        m_jobModified = false;
        emit documentChanged();
    } else {
        m_messages = written.error();
    }
    refreshProblems();
    if (!written)
        emit troubled();
    return written.has_value();
}

void Session::reload() {
    Result<Document> document = loadDocument(m_document.path);
    if (!document) {
        tell(document.error());
        return;
    }
    m_document = std::move(*document);
    m_keptMine = false;
    m_watch.watch(toQString(m_document.path));
    emit textReplaced();
    emit documentChanged();
    interpret();
}

void Session::keepMine() {
    m_keptMine = true;
    setTextModified(true);
}

void Session::watchedFileChanged() {
    emit fileChangedOnDisk();
}

void Session::applyEdit(std::size_t offset, std::size_t removed, std::string_view inserted) {
    m_document.text = m_document.text.replaced(offset, removed, inserted);
    m_editPause.start();
}

void Session::setTextModified(bool modified) {
    modified = modified || m_keptMine;
    if (m_document.modified == modified)
        return;
    m_document.modified = modified;
    emit documentChanged();
}

// Interpretation and simulation.

std::string Session::nameForMessages() const {
    return m_document.path.empty() ? tr("untitled").toStdString() : m_document.path.string();
}

bool Session::isInText(const Diagnostic& problem) const {
    return problem.where.line > 0 && (problem.file.empty() || problem.file == nameForMessages());
}

void Session::interpret() {
    m_editPause.stop();
    InterpretOptions options;
    options.file = nameForMessages();
    options.blockDelete = m_setup->blockDelete;
    options.start = m_setup->start;
    m_source.request(m_document.text, std::move(options));
}

void Session::programReady(const std::shared_ptr<const Program>& program) {
    m_program = program;
    if (std::exchange(m_fitStock, false)) {
        Setup setup = *m_setup;
        setup.stock = fittedStock(*program, setup);
        setup.spacing = fittedSpacing(setup.stock);
        m_setup = std::make_shared<const Setup>(std::move(setup));
        emit setupChanged();
    }
    if (m_loadedSetup == m_setup && m_frame)
        continueWithEdit();
    else
        load();
    emit programChanged();
    refreshProblems();
    requestTick();
}

void Session::continueWithEdit() {
    // Who looks at the end wants to see the new end; else the block on the screen stays, cut anew.
    const bool atEnd = m_frame->block == m_frame->program->blockCount();
    const std::size_t block = atEnd ? m_program->blockCount() : std::min(m_frame->block, blockCount());
    m_simulation->post(EditCommand{m_program, ++m_generation});
    if (!m_playback.playing)
        m_simulation->post(SeekCommand{block});
}

void Session::load() {
    if (!m_program)
        return;
    m_simulationErrors.clear();
    m_loadedSetup = m_setup;
    m_frameStatistics.clear();
    m_drawnBlock = 0;
    m_simulation->post(LoadCommand{m_program, m_setup, m_parameters, ++m_generation});
}

void Session::simulationProgressed(double done) {
    if (m_exporting)
        return;
    setWork(done < 1 ? std::optional<Work>({tr("Simulating"), done}) : std::nullopt);
}

void Session::simulationFailed(const Diagnostics& errors) {
    m_simulationErrors = errors;
    m_loadedSetup.reset();
    refreshProblems();
    emit troubled();
}

void Session::takeFrame() {
    FramePtr frame = m_simulation->takeFrame();
    if (!frame || frame->generation != m_generation)
        return;
    m_frame = std::move(frame);
    updatePlaying();
    if (m_frame->findings.size() != m_shownFindings)
        refreshProblems();
}

void Session::updatePlaying() {
    const bool ended = m_frame->block == m_frame->program->blockCount() && !m_frame->playing;
    if (m_playback.playing && ended) {
        m_playback.playing = false;
        emit playbackChanged();
    }
}

void Session::onTick() {
    takeFrame();
    if (m_playback.playing && m_playback.everyBlock)
        m_paperWatchdog.start();
    emit tick(m_frame);
}

void Session::reportDrawn(std::uint64_t sequence, double uploadSeconds, double drawSeconds) {
    if (!m_frame || m_frame->sequence != sequence || sequence == m_drawnSequence)
        return;
    m_drawnSequence = sequence;
    m_paperWatchdog.stop();
    if (m_playback.everyBlock)
        m_simulation->frameShown(sequence);
    while (!m_frameStatistics.empty() && m_frameStatistics.back().lastBlock > m_frame->block)
        m_frameStatistics.pop_back();
    const std::size_t drawnBefore = std::exchange(m_drawnBlock, m_frame->block);
    if (m_frame->block <= drawnBefore)
        return;
    FrameStatistics row = frameRow(*m_frame, drawnBefore);
    row.uploadSeconds = static_cast<float>(uploadSeconds);
    row.drawSeconds = static_cast<float>(drawSeconds);
    m_frameStatistics.push_back(row);
}

// Playback.

void Session::play() {
    if (!m_program || m_playback.playing)
        return;
    takeFrame(); // an older frame must not look like the end of what starts now
    if (block() == blockCount())
        m_simulation->post(SeekCommand{0});
    m_playback.playing = true;
    m_simulation->post(PlayCommand{m_playback.blocksPerSecond, m_playback.everyBlock});
    emit playbackChanged();
}

void Session::pause() {
    m_simulation->post(PauseCommand{});
    if (!std::exchange(m_playback.playing, false))
        return;
    emit playbackChanged();
}

void Session::togglePlay() {
    if (m_playback.playing)
        pause();
    else
        play();
}

void Session::step(std::ptrdiff_t blocks) {
    // The command pauses by itself; a PauseCommand before it would drop the steps that are still under way.
    m_simulation->post(StepCommand{blocks});
    if (std::exchange(m_playback.playing, false))
        emit playbackChanged();
}

void Session::seek(std::size_t block) {
    m_simulation->post(SeekCommand{std::min(block, blockCount())});
    if (m_playback.playing)
        m_simulation->post(PlayCommand{m_playback.blocksPerSecond, m_playback.everyBlock});
}

void Session::stepToToolChange(int direction) {
    if (!m_program)
        return;
    pause();
    std::optional<std::size_t> target;
    for (const ToolChangeMark& mark : toolChangeMarks(*m_program)) {
        if (direction < 0 && mark.block < block())
            target = mark.block;
        if (direction > 0 && mark.block > block() && !target)
            target = mark.block;
    }
    if (target)
        seek(*target);
}

void Session::seekToLine(std::uint32_t line) {
    if (m_program)
        seek(m_program->blocksAfterLine(line));
}

void Session::setSpeed(double blocksPerSecond, bool everyBlock) {
    m_playback.blocksPerSecond = blocksPerSecond;
    m_playback.everyBlock = everyBlock;
    if (m_playback.playing)
        m_simulation->post(PlayCommand{blocksPerSecond, everyBlock});
    emit playbackChanged();
}

// Setup and parameters.

void Session::setParameters(const DecimationParameters& parameters) {
    if (parameters == m_parameters)
        return;
    m_parameters = parameters;
    m_jobModified = m_jobModified || !m_jobFile.isEmpty();
    m_simulation->post(ParametersCommand{parameters});
    emit parametersChanged();
    emit documentChanged();
}

Result<void> Session::setSetup(const Setup& setup) {
    if (setup == *m_setup)
        return {};
    const Result<Grid> grid = makeGrid(setup.stock, setup.spacing);
    if (!grid)
        return tl::unexpected(grid.error());
    Result<void> fits = checkMemory(setup.stock, *grid, static_cast<double>(availableMemoryBytes()));
    if (!fits)
        return fits;
    const bool otherProgram = setup.blockDelete != m_setup->blockDelete || setup.start != m_setup->start;
    const std::size_t blockBefore = block();
    m_setup = std::make_shared<const Setup>(setup);
    m_jobModified = true;
    if (otherProgram) {
        interpret();
    } else {
        load();
        m_simulation->post(SeekCommand{blockBefore});
        if (m_playback.playing)
            m_simulation->post(PlayCommand{m_playback.blocksPerSecond, m_playback.everyBlock});
    }
    emit setupChanged();
    emit documentChanged();
    return {};
}

StockBox Session::stockFittedToProgram() const {
    return m_program ? fittedStock(*m_program, *m_setup) : m_setup->stock;
}

// Export, progress, problems.

void Session::exportStl(const QString& file, const ExportOptions& options) {
    takeFrame();
    if (!m_frame) {
        tell(failure("no-stock", PROVEOUT_TEXT("Core", "There is no stock to export yet.")).value());
        return;
    }
    m_messages.clear();
    m_exporting = true;
    setWork(Work{tr("Exporting STL"), 0});
    m_export.start(m_frame, file, options,
                   [this](const Result<ExportSummary>& result) { exportDone(result); });
}

void Session::exportDone(const Result<ExportSummary>& result) {
    m_exporting = false;
    setWork(std::nullopt);
    if (!result) {
        tell(result.error());
        return;
    }
    m_lastExport = *result;
    refreshProblems();
    emit exported(*result);
}

void Session::cancelWork() {
    if (m_exporting)
        m_export.cancel();
    else
        m_simulation->cancel();
}

void Session::setWork(std::optional<Work> work) {
    m_work = std::move(work);
    emit workChanged();
}

void Session::tell(const Diagnostics& messages) {
    m_messages = messages;
    refreshProblems();
    if (!messages.empty())
        emit troubled();
}

void Session::clearMessages() {
    tell({});
}

void Session::refreshProblems() {
    m_problems = m_messages;
    m_problems.insert(m_problems.end(), m_simulationErrors.begin(), m_simulationErrors.end());
    if (m_program)
        m_problems.insert(m_problems.end(), m_program->diagnostics().begin(), m_program->diagnostics().end());
    m_shownFindings = m_frame ? m_frame->findings.size() : 0;
    if (m_frame)
        m_problems.insert(m_problems.end(), m_frame->findings.begin(), m_frame->findings.end());
    emit problemsChanged();
}

} // namespace proveout
