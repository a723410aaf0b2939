// SPDX-License-Identifier: GPL-3.0-or-later
// The hub of the workstation: panels talk to it, never to each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QTimer>

#include "core/base/diagnostic.h"
#include "core/decimation/regions/parameters.h"
#include "core/nc/program/program.h"
#include "core/simulation/run/frame.h"
#include "core/simulation/run/statistics.h"
#include "core/simulation/setup/setup.h"
#include "core/simulation/thread/breakpoints.h"
#include "core/simulation/thread/simulation_thread.h"
#include "core/simulation/time/machine_time.h"
#include "ui/block_search.h"
#include "ui/document_reader.h"
#include "ui/export_job.h"
#include "ui/file_watch.h"
#include "ui/frame_log.h"
#include "ui/job_document.h"
#include "ui/job_history.h"
#include "ui/newest_task.h"
#include "ui/playback.h"
#include "ui/played_parameters.h"
#include "ui/program_index.h"
#include "ui/program_source.h"
#include "ui/repaint_tick.h"

namespace proveout {

/// Long work under way that can be cancelled. Value type.
struct Work {
    QString label;
    double done = 0; ///< in [0, 1]

    friend bool operator==(const Work&, const Work&) = default;
};

/// Holds one document with its setup, parameters, program, playback and newest frame, and owns the threads
/// that interpret, simulate and export. Thread: the UI thread, all of it; no call waits for work.
/// Repainting: panels that show the simulation repaint in `tick` and nowhere else while it plays, because
/// any repaint in a window with a QOpenGLWidget composes the whole window again.
class Session : public QObject {
    Q_OBJECT

public:
    explicit Session(QObject* parent = nullptr);
    ~Session() override;

    /// False until a file was opened or a new one begun: the start page is shown then.
    [[nodiscard]] bool hasDocument() const { return m_hasDocument; }
    [[nodiscard]] const Document& document() const { return m_job.text(); }
    /// The job file that setup and parameters came from or were saved to; empty where there is none.
    [[nodiscard]] const QString& jobFile() const { return m_job.jobFile(); }
    /// Whether text, or setup and parameters of a job, hold changes that are not on the disk.
    [[nodiscard]] bool modified() const { return m_job.modified(); }
    /// Whether set-up or parameters hold changes that no job file has.
    [[nodiscard]] bool jobModified() const { return m_job.jobModified(); }
    /// Text, setup and parameters with their files, as one value.
    [[nodiscard]] const JobDocument& job() const { return m_job; }

    [[nodiscard]] const Setup& setup() const { return *m_job.setup(); }
    [[nodiscard]] const DecimationParameters& parameters() const { return m_job.parameters(); }
    /// The newest interpretation; null before the first one. May be ahead of frame()->program.
    [[nodiscard]] const std::shared_ptr<const Program>& program() const { return m_program; }
    /// How long the machine takes for program(); null while that is not known yet.
    [[nodiscard]] const std::shared_ptr<const MachineTimes>& times() const { return m_times; }
    /// As described by the job or the user; nothing: the values of Machine() are assumed.
    [[nodiscard]] const std::optional<Machine>& machine() const { return m_job.machine(); }
    [[nodiscard]] const std::vector<Breakpoint>& breakpoints() const { return m_breakpoints; }
    /// What program() cuts.
    [[nodiscard]] const CuttingExtent& cutting() const { return m_cutting; }
    /// Whether the text is known to be no program of ours: there is no frame of it.
    [[nodiscard]] bool isForeign() const { return m_program && m_program->foreignKind() != nullptr; }
    /// Whether program() is only the beginning of one whose rest is still being read.
    [[nodiscard]] bool isReading() const { return m_begun; }
    /// The newest frame; null before the first one of a document.
    [[nodiscard]] const FramePtr& frame() const { return m_frame; }
    [[nodiscard]] std::size_t blockCount() const { return m_program ? m_program->blockCount() : 0; }
    /// Blocks executed in the newest frame: 0 … blockCount().
    [[nodiscard]] std::size_t block() const { return m_frame ? m_frame->block : 0; }
    [[nodiscard]] const Playback& playback() const { return m_playback; }
    /// One row per frame that was drawn, ascending by lastBlock; rows beyond a seek back are dropped when the
    /// blocks are drawn anew.
    [[nodiscard]] const std::vector<FrameStatistics>& frameStatistics() const { return m_frameLog.rows(); }
    /// Where playback shows all faces because decimation costs more than it saves: the figures; null else.
    /// parameters() stay what the user wants, and hold again at rest.
    [[nodiscard]] const HoldBack* heldBack() const { return m_played.held(m_playback.playing); }
    /// Messages about files, then those of the program, then those of the simulation.
    [[nodiscard]] const Diagnostics& problems() const { return m_problems; }
    /// Whether the place of a problem is one of the open text; others name their file (a job file, say).
    [[nodiscard]] static bool isInText(const Diagnostic& problem);
    [[nodiscard]] const std::optional<Work>& work() const { return m_work; }
    [[nodiscard]] bool exporting() const { return m_exported.has_value(); }
    /// Whether a file is being read whose content will take the place of the document, or of its text.
    [[nodiscard]] bool isOpening() const { return m_reader.isReading(); }
    /// What the last export wrote; empty before the first one.
    [[nodiscard]] const std::optional<ExportSummary>& lastExport() const { return m_lastExport; }

    /// Who draws a frame calls this afterwards, in paintGL or in place of it: appends a row of
    /// frameStatistics() and, in paper mode, lets the next block be cut. Frames drawn again count once.
    void reportDrawn(std::uint64_t sequence, double uploadSeconds, double drawSeconds);
    /// Asks for a tick outside playback, e.g. after a colour was changed in a panel.
    void requestTick() { m_tick.request(); }

    /// Opens an NC program or a `.proveout` job: it is read in the background, and takes the place of the
    /// document when it is there whole (opened()). What went wrong stands in problems() (troubled()); the
    /// open document then stays as it was. Unsaved changes are the caller's to ask about before; a change of
    /// the document while the file is read stops the opening, so that none is lost. The newest file wins.
    void openFile(const QString& file);
    void newFile();
    /// Panels that wait for a rest in typing hand over what they have now (inputWanted()), e.g. to be saved.
    void collectChanges() { emit inputWanted(); }
    /// Opens kept work as openFile() opens a file; `done` is called when it is there.
    void restore(const KeptWork& kept, std::function<void()> done);
    /// Writes text and job to where they came from. False where that failed, where there is no path yet, and
    /// where a file has been changed by somebody else: see conflict().
    bool save();
    bool saveAs(const QString& file);
    bool saveJobAs(const QString& file);
    /// What save() would overwrite although it is newer than what the window has read: the files are compared
    /// now, by content. Nothing where there is no such, or no longer.
    [[nodiscard]] std::optional<DiskConflict> conflict() const;
    [[nodiscard]] std::optional<DiskConflict> conflict(FilePart part) const { return m_job.conflict(part); }
    /// The next save may overwrite it.
    void acceptDisk(const DiskConflict& conflict) { m_job.acceptDisk(conflict); }
    /// Saves a part under a new name beside its file, which stays as it is. False where that failed.
    bool saveBeside(FilePart part);
    /// Setup and parameters stay, but no longer belong to a job file.
    void detachJob();
    /// Reads the text again from the disk, in the background as openFile() does.
    void reload();
    /// Leaves the text as it is although the file has changed; it counts as modified, and may be saved over
    /// what the file holds now.
    void keepMine();
    /// The same of setup and parameters, for the job file.
    void reloadJob();
    void keepMyJob();
    /// The same of the file that the stock was read from: its body stays what it was until it is read again.
    void reloadStock();
    void keepStock();

    /// The user replaced the bytes [offset, offset + removed) of the text. Interprets anew in the background.
    void applyEdit(std::size_t offset, std::size_t removed, std::string_view inserted);
    /// The editor's undo reached or left the saved text.
    void setTextModified(bool modified);

    void play();
    void pause();
    void togglePlay();
    void step(std::ptrdiff_t blocks);     ///< pauses
    void seek(std::size_t block);         ///< goes on playing where it played
    void stepToToolChange(int direction); ///< -1: the previous one, +1: the next one; pauses
    void seekToLine(std::uint32_t line);  ///< the state after source line `line`, 1-based
    /// Looks in the background for the block that made a place, and goes there (placeTold()): its line is
    /// asked to be seen, and it is the last block that is cut. Pauses. Whatever else moves the play head, or
    /// changes the program or its set-up, makes the question void.
    void goToBlockThatMade(const PickedPlace& place);
    /// To where the play head was before it went there the last time.
    void returnFromJump();
    [[nodiscard]] bool canReturn() const { return !m_leftBlocks.empty(); }
    void setSpeed(double unitsPerSecond, bool everyBlock = false);
    void setPlayBy(PlayBy by); ///< at the same multiple of its unit speed
    void setMachine(const Machine& machine);
    void setBreakpoints(std::vector<Breakpoint> breakpoints);
    /// Where there is the same already, it is switched on.
    void addBreakpoint(const Breakpoint& added);
    /// Sets one at a line, or takes it away.
    void toggleBreakpoint(std::uint32_t line);
    /// An edit has added (or taken away) lines behind a place in `line`: breakpoints behind it move along.
    void moveBreakpoints(std::uint32_t line, bool fromItsStart, std::ptrdiff_t added);
    /// Bytes that the simulation may keep to go back quickly.
    void setCheckpointBudget(std::size_t bytes);

    void setParameters(const DecimationParameters& parameters);
    /// Errors (stock, grid, memory) are told by the result and change nothing.
    /// The spacing of an automatic grid is found here, whatever `wanted` has.
    Result<void> setSetup(const Setup& wanted);
    /// The stock that holds the program's cutting motions (fittedStock()); the present one where there
    /// is no motion.
    [[nodiscard]] StockBox stockFittedToProgram() const;

    /// The user's steps in setup, parameters and machine since the document was opened.
    [[nodiscard]] JobHistory& history() { return m_history; }
    /// Carries out a command that changes setup, parameters or machine: a step of its own in the history,
    /// after what panels still hold back.
    void asOneStep(const std::function<void()>& command);
    /// With what panels still hold back.
    void undoStep();
    void redoStep();

    /// Writes the stock of the newest frame in the background; work() tells how far it is.
    void exportMesh(const QString& file, const ExportOptions& options);
    /// Saves it for the next set-up, in the background too.
    void saveStock(const QString& file);
    void cancelWork();
    /// Shows messages that are about no part of the program, e.g. a dropped file that cannot be used, in
    /// place of those before.
    void tell(const Diagnostics& messages);

signals:
    /// Another document, or the same one under another name or with another modified state.
    void documentChanged();
    /// Setup, parameters and machine are those of another file: what panels hold back is void.
    void jobReplaced();
    /// The text was replaced as a whole (opened, reloaded): views load it anew.
    void textReplaced();
    /// openFile() is through: the document is that of the file.
    void opened(const QString& file);
    void programChanged();
    void setupChanged();
    void parametersChanged();
    void playbackChanged(); ///< canReturn() too
    void machineChanged();
    /// Input that a panel holds back while the user is still typing is wanted now.
    void inputWanted();
    void timesChanged();
    void breakpointsChanged();
    /// A breakpoint has stopped the run.
    void stoppedAt(const BreakpointHit& hit);
    void problemsChanged();
    /// A job was not opened, because it names files outside its folder that the user has not allowed.
    void outsideFilesNamed(const QString& job, const std::vector<std::filesystem::path>& files);
    /// What was asked for could not be done; why stands in problems().
    void troubled();
    void workChanged();
    void exported(const ExportSummary& summary);
    /// The file of the document is gone, or no longer what was read or written.
    void fileChangedOnDisk();
    /// The file of the document is again what the window holds.
    void fileWritten();
    /// The job file is no longer what was read or written; false: it is again.
    void jobChangedOnDisk(bool changed);
    /// The same of the file of the stock.
    void stockChangedOnDisk(bool changed);
    /// Someone asks to see a source line (1-based): the editor goes there.
    void lineRequested(std::uint32_t line, int column);
    /// Someone asks to see a tool of the table, or to define the one with this number.
    void toolRequested(int number);
    /// The answer to goToBlockThatMade().
    void placeTold(const PlaceAnswer& answer);
    /// The one coalesced repaint: the newest frame, null where there is none. At most 30 times a second, less
    /// often where painting takes long.
    void tick(const FramePtr& frame);

private:
    void adopt(JobDocument job);
    void change(const JobValues& from, const JobValues& to);
    [[nodiscard]] Result<void> checkMap(const Setup& setup) const;
    void fitUndone();
    void runOn(const Setup& before);
    bool saved(const Result<void>& written, bool text, bool job);
    void watchFiles();
    void watchedJobChanged();
    void watchStock();
    void watchedStockChanged();
    void tellStockFile(bool changed);
    void takeStock(const Setup& read);
    bool told(const Result<void>& result);
    void watchedFileChanged();
    void interpret();
    void textRead(Result<Document> text);
    void adoptProposals(const ToolProposals& proposals);
    void stopOpening();
    void refuseOpening(const QString& file, const Diagnostics& errors);
    void adoptProgram(const std::shared_ptr<const Program>& program, const CuttingExtent& cutting,
                      bool whole);
    void simulate(bool more);
    void fitStock(bool forNow);
    void fitGrid();
    void refuseStock(const Diagnostics& errors);
    void showNoStock();
    void dropFrame();
    void continueWithEdit();
    void continueWithMore();
    void load();
    void tellSetup(const DecimationParameters& before);
    void simulationProgressed(double done);
    void simulationFailed(const Diagnostics& errors, std::uint64_t generation);
    void takeFrame();
    void onTick();
    void stopPlaying();
    void restartHoldBack();
    void goTo(const PlaceAnswer& answer);
    [[nodiscard]] bool isPresent(const Frame& moment) const;
    void forgetJumps();
    [[nodiscard]] std::size_t target() const;
    SeekCommand seekTo(std::size_t block);
    void postPlay();
    void postStops();
    void askForTimes();
    void postParameters();
    void refreshProblems();
    void showWork();
    void exportDone(const Result<ExportSummary>& result);

    JobDocument m_job;
    JobHistory m_history;
    bool m_hasDocument = false;
    Playback m_playback;

    std::shared_ptr<const Program> m_program;
    CuttingExtent m_cutting;
    ToolProposals m_proposals;                   ///< what the comments of the text describe
    std::shared_ptr<const MachineTimes> m_times; ///< of m_program, or null
    std::vector<Breakpoint> m_breakpoints;
    std::optional<std::size_t> m_checkpointBudget; ///< nothing: the simulation's own
    std::shared_ptr<const Setup> m_loadedSetup;    ///< what the simulation runs on; null: nothing loaded
    std::uint64_t m_generation = 0;
    std::uint64_t m_loadGeneration = 0; ///< of the newest load; failures of older ones are nobody's concern
    FramePtr m_frame;
    /// Where the play head is on its way to, and the ticket of the command that sends it there.
    struct Sought {
        std::size_t block = 0;
        std::uint64_t ticket = 0;
    };
    std::optional<Sought> m_sought;
    std::uint64_t m_ticket = 0;

    FrameLog m_frameLog;
    PlayedParameters m_played;
    QTimer m_paperWatchdog; ///< lets paper mode go on while nobody draws (a minimised window)

    Diagnostics m_messages;         ///< about files and jobs
    Diagnostics m_stockFile;        ///< about the file of the stock, as long as it holds
    Diagnostics m_simulationErrors; ///< of the last load
    Diagnostics m_problems;
    bool m_begun = false;  ///< the program is only its beginning
    bool m_isRead = false; ///< m_program is that of the text and the set-up
    std::optional<Work> m_work;
    // How far what may be told by it is, in [0, 1]; empty where it is not under way.
    std::optional<double> m_exported;
    std::optional<double> m_interpreted; ///< a long text
    std::optional<double> m_simulated;
    std::optional<ExportSummary> m_lastExport;

    FileWatch m_watch;
    FileWatch m_jobWatch;
    FileWatch m_stockWatch;
    std::shared_ptr<const StockBody> m_watchedStock; ///< that was read from the file of m_stockWatch
    RepaintTick m_tick;
    QTimer m_editPause; ///< typing is interpreted after a short rest
    DocumentReader m_reader;
    ExportJob m_export;
    ProgramSource m_source;
    NewestTask m_timing;
    NewestTask m_stockReading;
    BlockSearch m_search;
    std::vector<std::size_t> m_leftBlocks;          ///< where goToBlockThatMade() has led away from
    std::unique_ptr<SimulationThread> m_simulation; ///< last: its thread ends before what it posts to
};

} // namespace proveout
