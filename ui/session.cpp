// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session.h"

#include <algorithm>
#include <utility>

#include <QMetaObject>

#include "core/base/text.h"
#include "core/simulation/run/interpretation.h"
#include "ui/program_index.h"

namespace proveout {

namespace {

constexpr int kEditPauseMs = 120;
constexpr int kPaperWatchdogMs = 2000;

} // namespace

Session::Session(QObject* parent)
    : QObject(parent), m_history([this](const JobValues& from, const JobValues& to) { change(from, to); }) {
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
    connect(&m_jobWatch, &FileWatch::changed, this, &Session::watchedJobChanged);
    connect(&m_stockWatch, &FileWatch::changed, this, &Session::watchedStockChanged);
    connect(this, &Session::setupChanged, this, &Session::watchStock);
    connect(&m_tick, &RepaintTick::fired, this, &Session::onTick);
    connect(&m_source, &ProgramSource::proposed, this, &Session::adoptProposals);
    connect(&m_source, &ProgramSource::begun, this,
            [this](const auto& program, const auto& cutting) { adoptProgram(program, cutting, false); });
    connect(&m_reader, &DocumentReader::progressChanged, this, &Session::showWork);
    connect(&m_source, &ProgramSource::progressed, this, [this](double done) {
        m_interpreted = done;
        showWork();
    });
    connect(&m_source, &ProgramSource::ready, this, [this](const auto& program, const auto& cutting) {
        m_interpreted.reset();
        showWork();
        adoptProgram(program, cutting, true);
    });
    connect(&m_source, &ProgramSource::failed, this, [this](const Diagnostics& errors) {
        m_interpreted.reset();
        showWork();
        m_begun = false; // no more comes
        tell(errors);
    });
    connect(&m_search, &BlockSearch::progressed, this, &Session::showWork);
    connect(&m_search, &BlockSearch::answered, this, &Session::goTo);
    connect(&m_search, &BlockSearch::failed, this, &Session::tell);
    connect(&m_export, &ExportJob::progressed, this, [this](double done) {
        if (m_exported)
            m_exported = done;
        showWork();
    });

    SimulationListener listener;
    listener.frameReady = [this] {
        QMetaObject::invokeMethod(&m_tick, &RepaintTick::request, Qt::QueuedConnection);
    };
    listener.progress = [this](double done) {
        QMetaObject::invokeMethod(
            this, [this, done] { simulationProgressed(done); }, Qt::QueuedConnection);
    };
    listener.failed = [this](Diagnostics errors, std::uint64_t generation) {
        QMetaObject::invokeMethod(
            this, [this, errors = std::move(errors), generation] { simulationFailed(errors, generation); },
            Qt::QueuedConnection);
    };
    m_simulation = std::make_unique<SimulationThread>(std::move(listener));
}

Session::~Session() = default;

// Interpretation and simulation.

bool Session::isInText(const Diagnostic& problem) {
    return problem.where.line > 0 && problem.file.empty();
}

void Session::interpret() {
    m_editPause.stop();
    m_search.cancel();
    m_isRead = false;
    InterpretOptions options = interpretOptions(setup(), document().path);
    options.file.clear(); // messages without a file are about the text in the editor
    if (m_job.wantsStock())
        options.part = {};
    m_interpreted.reset();
    showWork();
    m_source.request(document().text, std::move(options), !m_program,
                     KnownTools{setup().tools, m_proposals, setup().startTool.has_value()});
}

/// `whole`: else its rest is still being read, and may leave the stock.
void Session::adoptProgram(const std::shared_ptr<const Program>& program, const CuttingExtent& cutting,
                           bool whole) {
    const bool more = std::exchange(m_begun, !whole);
    m_search.cancel();
    m_isRead = true;
    m_program = program;
    m_cutting = cutting;
    if (m_job.wantsStock()) {
        fitStock(!whole);
        if (whole && program->asksForStock())
            return interpret(); // now there is a stock to probe
    }
    fitGrid();
    if (!more)
        forgetJumps();
    askForTimes();
    simulate(more);
    emit programChanged();
    refreshProblems();
    requestTick();
}

/// `more`: the program before was the beginning of this one.
void Session::simulate(bool more) {
    if (isForeign())
        showNoStock();
    else if (m_loadedSetup != m_job.setup() || !m_frame)
        load();
    else if (more)
        continueWithMore();
    else
        continueWithEdit();
}

void Session::continueWithEdit() {
    // Who looks at the end wants to see the new end; else the block on the screen stays, cut anew.
    const bool atEnd = target() == m_frame->program->blockCount();
    const std::size_t block = atEnd ? blockCount() : target();
    m_simulation->post(EditCommand{m_program, ++m_generation});
    if (!m_playback.playing)
        m_simulation->post(seekTo(block));
}

/// The program goes on behind what is there: nobody is led elsewhere.
void Session::continueWithMore() {
    m_simulation->post(EditCommand{m_program, ++m_generation});
    if (m_playback.playing)
        postPlay();
}

void Session::load() {
    if (!m_program || isForeign())
        return;
    if (const Result<void> whole = checkShape(setup().shape); !whole)
        return refuseStock(whole.error());
    m_search.cancel();
    m_simulationErrors.clear();
    m_loadedSetup = m_job.setup();
    m_frameLog.clear();
    m_loadGeneration = ++m_generation;
    m_played.loaded(parameters());
    m_simulation->post(LoadCommand{m_program, m_job.setup(), parameters(), m_generation});
    postStops();
    // What was sought before there was a simulation has been dropped: it would count for ever.
    if (m_sought || block() > 0)
        m_simulation->post(seekTo(target()));
    if (m_playback.playing)
        postPlay();
}

/// The stock is not what it is called: nothing is shown in its place.
void Session::refuseStock(const Diagnostics& errors) {
    dropFrame();
    simulationFailed(errors, m_generation);
}

/// Nothing of the text is understood: an uncut stock would look like its result.
void Session::showNoStock() {
    m_simulationErrors.clear();
    m_loadedSetup.reset();
    dropFrame();
    stopPlaying();
}

void Session::dropFrame() {
    m_simulation->post(PauseCommand{});
    m_loadGeneration = ++m_generation; // frames under way are of what was before
    m_frame.reset();
    m_sought.reset();
    m_frameLog.clear();
    requestTick();
}

void Session::simulationProgressed(double done) {
    m_simulated = done < 1 ? std::optional(done) : std::nullopt;
    showWork();
}

void Session::simulationFailed(const Diagnostics& errors, std::uint64_t generation) {
    if (generation < m_loadGeneration)
        return;
    m_simulationErrors = errors;
    m_loadedSetup.reset();
    m_sought.reset();
    stopPlaying();
    refreshProblems();
    emit troubled();
}

void Session::takeFrame() {
    FramePtr frame = m_simulation->takeFrame();
    if (!frame || frame->generation != m_generation)
        return;
    const FramePtr before = std::exchange(m_frame, std::move(frame));
    if (m_sought && m_frame->seekOver >= m_sought->ticket)
        m_sought.reset();
    if (m_frame->block == m_frame->program->blockCount() && !m_frame->playing && !m_begun)
        stopPlaying();
    if (!before || before->findings != m_frame->findings)
        refreshProblems();
    if (m_frame->stoppedBy && (!before || before->stoppedBy != m_frame->stoppedBy)) {
        stopPlaying();
        emit stoppedAt(*m_frame->stoppedBy);
    }
}

void Session::stopPlaying() {
    if (!std::exchange(m_playback.playing, false))
        return;
    postParameters();
    emit playbackChanged();
}

void Session::restartHoldBack() {
    m_played.restart(parameters(), m_frame && m_frame->generation == m_generation ? m_frame.get() : nullptr);
}

void Session::postParameters() {
    if (const auto due = m_played.due(parameters(), m_playback.playing))
        m_simulation->post(ParametersCommand{*due});
}

void Session::onTick() {
    takeFrame();
    if (m_playback.playing && m_playback.everyBlock)
        m_paperWatchdog.start();
    emit tick(m_frame);
}

void Session::reportDrawn(std::uint64_t sequence, double uploadSeconds, double drawSeconds) {
    if (!m_frame || m_frame->sequence != sequence || !m_frameLog.add(*m_frame, uploadSeconds, drawSeconds))
        return;
    m_paperWatchdog.stop();
    if (!m_played.isWeighing())
        restartHoldBack();
    if (m_playback.playing && !m_frameLog.rows().empty())
        m_played.weigh(*m_frame, m_frameLog.rows().back());
    postParameters();
    if (m_playback.everyBlock)
        m_simulation->frameShown(sequence);
    if (!m_playback.playing)
        requestTick(); // no other frame comes to show the new row with
}

// Export, progress, problems.

void Session::exportMesh(const QString& file, const ExportOptions& options) {
    if (m_exported) {
        tell(
            failure("export-running",
                    PROVEOUT_TEXT("Core", "An export is still being written; wait for its end or cancel it."))
                .value());
        return;
    }
    takeFrame();
    if (!m_frame) {
        tell(failure("no-stock", PROVEOUT_TEXT("Core", "There is no stock to export yet.")).value());
        return;
    }
    m_messages.clear();
    m_exported = 0;
    showWork();
    // Held back is playback, not what the user wants in a file.
    auto moment = std::make_shared<Frame>(*m_frame);
    moment->parameters = parameters();
    m_export.start(std::move(moment), file, options,
                   [this](const Result<ExportSummary>& result) { exportDone(result); });
}

void Session::saveStock(const QString& file) {
    takeFrame();
    ExportOptions options{.format = findFormat("stock")};
    options.provenance.program = document().path.filename().string();
    if (m_frame) {
        options.provenance.blocks = m_frame->block;
        options.provenance.line = m_frame->block > 0 ? m_frame->program->blockLine(m_frame->block - 1) : 0;
        options.provenance.finished = m_frame->block == m_frame->program->blockCount() && !m_begun;
    }
    exportMesh(file, options);
}

void Session::exportDone(const Result<ExportSummary>& result) {
    m_exported.reset();
    showWork();
    if (!result) {
        tell(result.error());
        return;
    }
    m_lastExport = *result;
    m_messages.insert(m_messages.end(), result->warnings.begin(), result->warnings.end());
    refreshProblems();
    if (!result->warnings.empty())
        emit troubled();
    emit exported(*result);
}

void Session::cancelWork() {
    // What work() tells of.
    if (m_exported)
        return m_export.cancel();
    if (m_reader.progress())
        return m_reader.cancel();
    if (m_interpreted)
        return m_source.stop();
    if (m_search.done())
        return m_search.cancel();
    m_simulation->cancel();
    m_sought.reset();
    stopPlaying();
}

void Session::showWork() {
    std::optional<Work> work;
    if (m_exported)
        work = {tr("Exporting"), *m_exported};
    else if (m_reader.progress())
        work = {tr("Opening the file"), *m_reader.progress()};
    else if (m_interpreted)
        work = {tr("Reading the program"), *m_interpreted};
    else if (m_search.done())
        work = {tr("Looking for the block"), *m_search.done()};
    else if (m_simulated)
        work = {tr("Simulating"), *m_simulated};
    if (work == m_work)
        return;
    m_work = std::move(work);
    emit workChanged();
}

void Session::tell(const Diagnostics& messages) {
    m_messages = messages;
    refreshProblems();
    if (!messages.empty())
        emit troubled();
}

void Session::refreshProblems() {
    m_problems = m_messages;
    m_problems.insert(m_problems.end(), m_stockFile.begin(), m_stockFile.end());
    m_problems.insert(m_problems.end(), m_simulationErrors.begin(), m_simulationErrors.end());
    if (m_program)
        m_problems.insert(m_problems.end(), m_program->diagnostics().begin(), m_program->diagnostics().end());
    if (m_frame)
        m_problems.insert(m_problems.end(), m_frame->findings.begin(), m_frame->findings.end());
    emit problemsChanged();
}

} // namespace proveout
