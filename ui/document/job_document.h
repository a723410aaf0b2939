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
#include "core/simulation/setup/check_rules.h"
#include "core/simulation/setup/machine.h"
#include "core/simulation/setup/setup.h"
#include "ui/document/disk_copy.h"
#include "ui/document/document.h"

namespace proveout {

/// The two files of a document.
enum class FilePart : std::uint8_t { text, job };

/// A file that no longer has the content that this window last read or wrote. Value type.
struct DiskConflict {
    FilePart part = FilePart::text;
    std::filesystem::path file;
    NcText mine;    ///< what a save would write
    DiskCopy other; ///< the content of the file; no file if it is too large to be shown
    FileState state;
};

/// Unsaved work as it was backed up, with the files that it belongs to. Value type.
struct KeptWork {
    std::filesystem::path program;  ///< the file that the text belongs to; empty: not saved yet
    std::filesystem::path keptText; ///< where the text was backed up; empty: it had no changes
    std::string programDigest;      ///< DiskCopy::digest() of the program file at that time
    QString jobFile;                ///< the job file of setup and parameters; empty: none
    std::filesystem::path keptJob;  ///< backup, or the job file if it is unchanged; empty: there is neither
    std::string jobDigest;          ///< the same for the job file
    bool jobModified = false;
};

/// Setup, parameters and machine at one moment. Value type, cheap to copy.
struct JobValues {
    std::shared_ptr<const Setup> setup; ///< never null
    DecimationParameters parameters = {};
    std::optional<Machine> machine = {}; ///< empty: not defined
    CheckRules check = {};
    std::optional<PartSpec> part = {}; ///< empty: the stock is compared with nothing
    bool regionNamed = false; ///< otherwise the region size is the default, which depends on the z-map
    bool wantsStock = true;   ///< the stock is still to be fitted to the program
};

/// What File > Open reads and File > Save writes: a program text with its setup and decimation parameters,
/// and the job file that stores these two if there is one. Value type; one thread at a time.
class JobDocument {
public:
    /// A new text without a file name; nothing else is defined.
    JobDocument() = default;
    /// Reads an NC program or, if the extension says so, a `.proveout` job and the program that it names. A
    /// program alone comes with no tools and no stock of its own. Any thread. `allowed`: files outside its
    /// folder that a job may name. Errors: those of readJob() and loadDocument().
    [[nodiscard]] static Result<JobDocument> open(const QString& file, const WorkContext& context = {},
                                                  const OutsideRule& allowed = {});
    /// Reads backed-up work instead of the files that it belongs to, which stay unchanged; the work counts as
    /// unsaved. Any thread. Errors: those of open(), about the backup files.
    [[nodiscard]] static Result<JobDocument> restore(const KeptWork& kept, const WorkContext& context = {});
    /// Warnings about the job file that was read.
    [[nodiscard]] const Diagnostics& warnings() const { return m_warnings; }

    [[nodiscard]] const Document& text() const { return m_text; }
    [[nodiscard]] const QString& jobFile() const { return m_jobFile; } ///< empty if there is none
    [[nodiscard]] const std::shared_ptr<const Setup>& setup() const { return m_values.setup; } ///< never null
    [[nodiscard]] const DecimationParameters& parameters() const { return m_values.parameters; }
    [[nodiscard]] const std::optional<Machine>& machine() const { return m_values.machine; }
    [[nodiscard]] const CheckRules& check() const { return m_values.check; }
    [[nodiscard]] const std::optional<PartSpec>& part() const { return m_values.part; }
    [[nodiscard]] const JobValues& values() const { return m_values; }
    /// Whether the stock must still be fitted to the program, because neither a job nor the user has defined
    /// it.
    [[nodiscard]] bool wantsStock() const { return m_values.wantsStock; }
    /// Whether the stock is one that was fitted to the program, because neither a job nor the user has
    /// defined it.
    [[nodiscard]] bool stockFitted() const;
    /// Whether setup or parameters have changes that are not in a job file.
    [[nodiscard]] bool jobModified() const;
    /// Whether the tool table has such changes.
    [[nodiscard]] bool toolsModified() const;
    [[nodiscard]] bool modified() const { return m_text.modified || jobModified(); }
    /// Changes whenever something changes that would be saved or backed up.
    [[nodiscard]] std::uint64_t revision() const { return m_revision; }
    /// Setup and parameters as arguments for writeJob().
    [[nodiscard]] Job job() const;
    /// What the files contained when they were last read or written.
    [[nodiscard]] const DiskCopy& textOnDisk() const { return m_textOnDisk; }
    [[nodiscard]] const DiskCopy& jobOnDisk() const { return m_jobOnDisk; }
    /// State of the job file just before it was read.
    [[nodiscard]] const FileState& jobState() const { return m_jobState; }

    /// Writes each modified part that has a file. Errors: those of AtomicFile and writeJob(), with a hint; if
    /// another program has changed a file ("file-changed-on-disk"), nothing is written. Parts that were
    /// written before the error count as saved.
    [[nodiscard]] Result<void> save();
    /// Overwrites a file other than the current one whatever its content, because the file dialog has asked
    /// the user already.
    [[nodiscard]] Result<void> saveTextAs(const QString& file);
    [[nodiscard]] Result<void> saveJobAs(const QString& file);
    /// Whether saving this part would overwrite changes by another program; reads the file to find out.
    [[nodiscard]] std::optional<DiskConflict> conflict(FilePart part) const;
    /// Allows the next save to overwrite the content that the conflict shows, but nothing newer.
    void acceptDisk(const DiskConflict& conflict);
    /// Takes over the files of a copy that was saved. What has changed here since the copy was made counts as
    /// unsaved, even if the user undoes it.
    void takeFiles(const JobDocument& saved);
    /// Setup and parameters stay, but no longer belong to a job file.
    void detachJob() { m_jobFile.clear(); }
    /// Call it when the text was read again.
    void replaceText(Document text);
    /// Setup, parameters and machine of another document, read from the same job file again.
    void replaceJob(const JobDocument& other);

    /// Replaces the bytes [offset, offset + removed) of the text.
    void edit(std::size_t offset, std::size_t removed, std::string_view inserted);
    /// The file on disk was removed or changed by another program: the part needs saving from now on, even if
    /// the user undoes all changes.
    void keepMine();
    void keepMyJob();
    /// Returns whether that changed anything.
    bool setTextModified(bool modified);
    /// A region size that was not set explicitly becomes the default for the new z-map, which changes
    /// parameters().
    void setSetup(std::shared_ptr<const Setup> setup);
    /// Like setSetup, but for a setup that the program has computed: it does not count as an unsaved change.
    /// `forNow`: the stock must be fitted again later.
    void fitSetup(std::shared_ptr<const Setup> setup, bool forNow = false);
    void setParameters(const DecimationParameters& parameters);
    /// Sets one of the values that no other one depends on.
    template<class Value>
    void set(Value JobValues::*field, const Value& value) {
        ++m_revision;
        m_values.*field = value;
    }
    /// Applies the differences between two moments, as undo or redo does. Fields that are equal in both keep
    /// their current values.
    void change(const JobValues& from, const JobValues& to);

private:
    [[nodiscard]] static std::shared_ptr<const Setup> newSetup();
    [[nodiscard]] int defaultRegionHere(DecimationMethod method) const;

    /// Adopts setup and parameters of a job file, and returns the program that it names. Errors: those of
    /// readJob().
    [[nodiscard]] Result<std::filesystem::path> readSetup(const std::filesystem::path& file,
                                                          const OutsideRule& allowed);
    [[nodiscard]] std::filesystem::path pathOf(FilePart part) const;
    /// What a save of this part would write.
    [[nodiscard]] DiskCopy mine(FilePart part) const;
    /// Compares the file with what is known of it. A file that another program has changed to exactly what a
    /// save would write counts as the same.
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
    std::uint64_t m_jobSaves = 0;     ///< how often the job was read or saved
    std::uint64_t m_textRevision = 0; ///< changes with each change of the text, not when it is saved
    Diagnostics m_warnings;
    bool m_jobOutdated = false; ///< the job file must be written even if setup and parameters are unchanged
    JobValues m_values{.setup = newSetup()};
    JobValues m_saved = m_values; ///< those in the job file, or created for the program
};

} // namespace proveout
