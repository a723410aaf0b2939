// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <QString>

#include "core/base/diagnostic.h"
#include "core/base/work_context.h"
#include "core/decimation/regions/parameters.h"
#include "core/formats/job_file.h"
#include "core/simulation/setup/machine.h"
#include "core/simulation/setup/setup.h"
#include "ui/document/disk_copy.h"
#include "ui/document/document.h"

namespace proveout {

/// The two files of a document.
enum class FilePart : std::uint8_t { text, job };

/// A file that no longer holds what this window last read from it or wrote to it. Value type.
struct DiskConflict {
    FilePart part = FilePart::text;
    std::filesystem::path file;
    NcText mine;    ///< what a save would write
    DiskCopy other; ///< what the file holds; of no file where that is too large to be shown
    FileState state;
};

/// Unsaved work as it was kept beside the files that it belongs to. Value type.
struct KeptWork {
    std::filesystem::path program;  ///< the file that the text belongs to; empty: not saved yet
    std::filesystem::path keptText; ///< where the text was kept; empty: it had no changes
    std::string programDigest;      ///< DiskCopy::digest() of what the program held then
    QString jobFile;                ///< the job of setup and parameters; empty: none
    std::filesystem::path keptJob; ///< where setup and parameters were kept; empty: there was nothing to keep
    std::string jobDigest;         ///< as programDigest
    bool jobModified = false;
};

/// Setup, parameters and machine of one moment. Value type, cheap to copy.
struct JobValues {
    std::shared_ptr<const Setup> setup; ///< never null
    DecimationParameters parameters;
    std::optional<Machine> machine; ///< nothing: not described
    bool regionNamed = false;       ///< else the region size is the standard, and follows the map
    bool wantsStock = true;         ///< the stock is still to be fitted to the program
};

/// What File > Open reads and File > Save writes: a program text with its set-up and decimation parameters,
/// and the job file that holds these two where there is one. Value type; one thread at a time.
class JobDocument {
public:
    /// A text without a name, with nothing defined.
    JobDocument() = default;
    /// Reads an NC program or, told by its extension, a `.proveout` job and the program that it names. A
    /// program alone comes with no tools and no stock of its own. Any thread. `allowed`: files that a job may
    /// name outside its folder. Errors: those of readJob() and loadDocument().
    [[nodiscard]] static Result<JobDocument> open(const QString& file, const WorkContext& context = {},
                                                  const OutsideRule& allowed = {});
    /// Reads kept work in the place of the files that it belongs to, which stay as they are; what it holds
    /// counts as unsaved. Any thread. Errors: as of open(), about the kept files.
    [[nodiscard]] static Result<JobDocument> restore(const KeptWork& kept, const WorkContext& context = {});
    /// Reads a text alone. Any thread. Errors: those of loadDocument(), without a place.
    [[nodiscard]] static Result<Document> readText(const std::filesystem::path& file,
                                                   const WorkContext& context = {});
    /// What was strange about the job file that was read, yet no error.
    [[nodiscard]] const Diagnostics& warnings() const { return m_warnings; }

    [[nodiscard]] const Document& text() const { return m_text; }
    [[nodiscard]] const QString& jobFile() const { return m_jobFile; } ///< empty where there is none
    [[nodiscard]] const std::shared_ptr<const Setup>& setup() const { return m_setup; } ///< never null
    [[nodiscard]] const DecimationParameters& parameters() const { return m_parameters; }
    [[nodiscard]] const std::optional<Machine>& machine() const { return m_machine; }
    [[nodiscard]] JobValues values() const {
        return {m_setup, m_parameters, m_machine, m_regionNamed, m_wantsStock};
    }
    /// Whether the stock is still to be fitted to the program: no job and no user has given one.
    [[nodiscard]] bool wantsStock() const { return m_wantsStock; }
    /// Whether set-up or parameters hold changes that no job file has.
    [[nodiscard]] bool jobModified() const;
    /// Whether the tool table does.
    [[nodiscard]] bool toolsModified() const;
    [[nodiscard]] bool modified() const { return m_text.modified || jobModified(); }
    /// Another number after every change of what would be saved or kept.
    [[nodiscard]] std::uint64_t revision() const { return m_revision; }
    /// Setup and parameters as writeJob() takes them.
    [[nodiscard]] Job job() const;
    /// What the files held when they were last read or written.
    [[nodiscard]] const DiskCopy& textOnDisk() const { return m_textOnDisk; }
    [[nodiscard]] const DiskCopy& jobOnDisk() const { return m_jobOnDisk; }
    /// Of the job file, from before it was read.
    [[nodiscard]] const FileState& jobState() const { return m_jobState; }

    /// Writes what is modified and has a file. Errors: those of AtomicFile and writeJob(), with a hint; the
    /// file was changed by somebody else ("file-changed-on-disk"), and nothing is written then. What was
    /// written before the error counts as saved.
    [[nodiscard]] Result<void> save();
    /// A file other than the present one is overwritten, whatever it holds: who has chosen it was asked.
    [[nodiscard]] Result<void> saveTextAs(const QString& file);
    [[nodiscard]] Result<void> saveJobAs(const QString& file);
    /// Whether a save of this part would overwrite what somebody else has written: the file is read for that.
    [[nodiscard]] std::optional<DiskConflict> conflict(FilePart part) const;
    /// The next save may overwrite what the conflict says that the file holds, and nothing newer.
    void acceptDisk(const DiskConflict& conflict);
    /// Writes a part to a new file beside its present one, which stays as it is; the new one is the file of
    /// the part from then on. Errors: those of AtomicFile and writeJob().
    [[nodiscard]] Result<void> saveBeside(FilePart part);
    /// Set-up and parameters stay, but no longer belong to a job file.
    void detachJob() { m_jobFile.clear(); }
    /// The text was read again.
    void replaceText(Document text);
    /// Setup, parameters and machine of another document, read from the same job file again.
    void replaceJob(const JobDocument& other);

    /// Replaces the bytes [offset, offset + removed) of the text.
    void edit(std::size_t offset, std::size_t removed, std::string_view inserted);
    /// The file on the disk is gone or somebody else's from now on: saving is due whatever undo says.
    void keepMine();
    void keepMyJob();
    /// True where that changed something.
    bool setTextModified(bool modified);
    /// A region size that nobody named becomes the standard on the new map; then parameters() are others.
    void setSetup(std::shared_ptr<const Setup> setup);
    /// Like setSetup, but found out by us: nothing that the user would miss. `forNow`: the stock will still
    /// have to be fitted.
    void fitSetup(std::shared_ptr<const Setup> setup, bool forNow = false);
    void setParameters(const DecimationParameters& parameters);
    void setMachine(const Machine& machine);
    /// Brings what differs between two moments from the first to the second: a step undone or redone. What
    /// both have in common stays as it is now.
    void change(const JobValues& from, const JobValues& to);

private:
    [[nodiscard]] static std::shared_ptr<const Setup> newSetup();
    [[nodiscard]] int defaultRegionHere(DecimationMethod method) const;

    /// Takes setup and parameters of a job file, and gives the program that it names. Errors: of readJob().
    [[nodiscard]] Result<std::filesystem::path> readSetup(const std::filesystem::path& file,
                                                          const OutsideRule& allowed);
    [[nodiscard]] std::filesystem::path pathOf(FilePart part) const;
    /// What a save of this part would write.
    [[nodiscard]] DiskCopy mine(FilePart part) const;
    /// What its file holds compared with what is known of it. A file that others have changed into just what
    /// a save would write is the same.
    [[nodiscard]] Result<DiskState> diskState(FilePart part) const;
    [[nodiscard]] Result<void> mayReplace(FilePart part) const;
    void replaceSetup(std::shared_ptr<const Setup> setup);
    void jobSaved();

    Document m_text;
    DiskCopy m_textOnDisk;
    bool m_keptMine = false;
    QString m_jobFile;
    DiskCopy m_jobOnDisk;
    FileState m_jobState;
    std::uint64_t m_revision = 0;
    Diagnostics m_warnings;
    bool m_jobOutdated = false; ///< whatever setup and parameters are
    bool m_wantsStock = true;
    std::shared_ptr<const Setup> m_setup = newSetup();
    DecimationParameters m_parameters;
    std::optional<Machine> m_machine;
    struct {
        std::shared_ptr<const Setup> setup;
        DecimationParameters parameters;
        std::optional<Machine> machine;
    } m_saved{m_setup, {}, {}}; ///< as the job file has them, or as they were made for the program
    bool m_regionNamed = false; ///< else its size is the standard, and follows the map
};

} // namespace proveout
