// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <QString>

#include "core/base/diagnostic.h"
#include "core/base/work_context.h"
#include "core/decimation/parameters.h"
#include "core/simulation/machine.h"
#include "core/simulation/setup.h"
#include "ui/document.h"

namespace proveout {

/// What File > Open reads and File > Save writes: a program text with its set-up and decimation parameters,
/// and the job file that holds these two where there is one. Value type; one thread at a time.
class JobDocument {
public:
    /// A text without a name, with nothing defined.
    JobDocument() = default;
    /// Reads an NC program or, told by its extension, a `.proveout` job and the program that it names. A
    /// program alone comes with no tools and no stock of its own. Any thread. Errors: those of readJob() and
    /// loadDocument().
    [[nodiscard]] static Result<JobDocument> open(const QString& file, const WorkContext& context = {});
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
    /// Whether the stock is still to be fitted to the program: no job and no user has given one.
    [[nodiscard]] bool wantsStock() const { return m_wantsStock; }
    /// Whether set-up or parameters hold changes that no job file has.
    [[nodiscard]] bool jobModified() const { return m_jobModified; }
    [[nodiscard]] bool modified() const { return m_text.modified || m_jobModified; }

    /// Writes what is modified and has a file. Errors: those of AtomicFile and writeJob(); what was written
    /// before the error counts as saved.
    [[nodiscard]] Result<void> save();
    [[nodiscard]] Result<void> saveTextAs(const QString& file);
    [[nodiscard]] Result<void> saveJobAs(const QString& file);
    /// Set-up and parameters stay, but no longer belong to a job file.
    void detachJob() { m_jobFile.clear(); }
    /// The text was read again.
    void replaceText(Document text);

    /// Replaces the bytes [offset, offset + removed) of the text.
    void edit(std::size_t offset, std::size_t removed, std::string_view inserted);
    /// The file on the disk is gone or somebody else's from now on: saving is due whatever undo says.
    void keepMine();
    /// True where that changed something.
    bool setTextModified(bool modified);
    /// A region size that nobody named becomes the standard on the new map; then parameters() are others.
    void setSetup(std::shared_ptr<const Setup> setup);
    /// Like setSetup, but found out by us: nothing that the user would miss. `forNow`: the stock will still
    /// have to be fitted.
    void fitSetup(std::shared_ptr<const Setup> setup, bool forNow = false);
    void setParameters(const DecimationParameters& parameters);
    void setMachine(const Machine& machine);

private:
    [[nodiscard]] static std::shared_ptr<const Setup> newSetup();
    [[nodiscard]] int standardRegionHere(DecimationMethod method) const;

    Document m_text;
    bool m_keptMine = false;
    QString m_jobFile;
    Diagnostics m_warnings;
    bool m_jobModified = false;
    bool m_wantsStock = true;
    std::shared_ptr<const Setup> m_setup = newSetup();
    DecimationParameters m_parameters;
    std::optional<Machine> m_machine;
    bool m_regionNamed = false; ///< else its size is the standard, and follows the map
};

} // namespace proveout
