// SPDX-License-Identifier: GPL-3.0-or-later
// Judges the open documents in the background.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "app/cli/check_program.h"
#include "app/cli/check_steps.h"
#include "app/cli/lsp_diagnostics.h"
#include "app/cli/lsp_job.h"
#include "app/cli/lsp_transport.h"
#include "app/cli/lsp_worker.h"
#include "core/nc/run/resumable_interpreter.h"

namespace proveout::cli {

/// The dialect in which a document was interpreted last. Any thread.
class KnownDialect {
public:
    void set(DialectId dialect) { m_dialect = static_cast<int>(dialect); }
    [[nodiscard]] std::optional<DialectId> get() const {
        const int known = m_dialect;
        return known < 0 ? std::nullopt : std::optional(static_cast<DialectId>(known));
    }

private:
    std::atomic<int> m_dialect = -1;
};

/// Sends diagnostics, if they are of the present text of a document that is open. Any thread.
class LspPublisher {
public:
    explicit LspPublisher(LspOutput& output) : m_output(output) {}

    /// A new text; returns the number that publish() needs.
    [[nodiscard]] std::uint64_t begin(const std::string& uri);
    void close(const std::string& uri);
    void publish(const std::string& uri, std::uint64_t number, std::optional<std::int64_t> version,
                 nlohmann::json diagnostics);

private:
    LspOutput& m_output;
    std::mutex m_mutex;
    std::map<std::string, std::uint64_t> m_texts;
    std::uint64_t m_last = 0;
};

/// One thread interprets texts and reports what is found in them; another one runs programs that have a
/// stock, and reports everything. One thread calls it.
class LspAnalysis {
public:
    /// References must outlive it.
    LspAnalysis(const CheckOptions& options, LspOutput& output)
        : m_options(options), m_output(output), m_publisher(output) {}

    /// How the editor wants diagnostics; before the first document.
    void setForm(PositionEncoding encoding, bool relatedInformation) {
        m_encoding = encoding;
        m_relatedInformation = relatedInformation;
    }

    enum class Reason : std::uint8_t { opened, changed, saved };
    /// Judges a text after a pause if it was changed; returns where its dialect will be known.
    std::shared_ptr<const KnownDialect> judge(const std::string& uri, const LspDocument& document,
                                              std::optional<std::int64_t> version, Reason reason);
    void close(const std::string& uri);

private:
    /// What is kept of a document between two texts; used by the thread that interprets.
    struct Kept {
        Kept(const std::filesystem::path& file, const CheckOptions& options) : job(file, options) {}

        LspJob job;
        ResumableInterpreter interpreter{};
        ResumableInterpreter interpreterAssuming{}; ///< with an assumed tool in the spindle
        std::atomic<bool> refresh = true;
        std::shared_ptr<KnownDialect> dialect = std::make_shared<KnownDialect>();
    };
    struct Task {
        LspSubject subject;
        std::shared_ptr<Kept> kept;
        std::uint64_t number = 0;
        std::optional<std::int64_t> version;
    };

    void interpret(Task task, const std::stop_token& stop);
    void run(const Task& task, Job job, const InterpretedJob& read, const std::stop_token& stop);
    void publish(const Task& task, std::span<const CheckFinding> findings);
    /// Calls `work`, and reports an exception as a finding.
    template<class Work>
    void guarded(const Task& task, const Work& work);

    const CheckOptions& m_options;
    LspOutput& m_output;
    PositionEncoding m_encoding = PositionEncoding::utf16;
    bool m_relatedInformation = false;
    LspPublisher m_publisher;
    std::map<std::string, std::shared_ptr<Kept>> m_documents;
    LspWorker m_checks;
    LspWorker m_texts; ///< last: it hands work to the other one
};

} // namespace proveout::cli
