// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/cli/check_program.h"
#include "core/base/file_state.h"
#include "core/formats/job_file.h"

namespace proveout::cli {

/// The job file in the folder of a program whose program it is; the one with its name comes first. Nothing if
/// there is none. Reads at most a hundred job files, and of these only which program they name.
[[nodiscard]] std::optional<std::filesystem::path> jobBeside(const std::filesystem::path& program);

/// The job with which a document is judged, read again only if its file has changed. One thread.
class LspJob {
public:
    /// `file`: the program; empty: it has none.
    LspJob(std::filesystem::path file, const CheckOptions& options)
        : m_file(std::move(file)), m_options(options) {}

    /// Searches for a job file and reads all files again.
    void refresh();
    /// Errors: the job file, or an option. A valid job without the job file is then in fallback().
    [[nodiscard]] Result<Job> job();
    [[nodiscard]] Job fallback() const;
    /// Whether the last job() has a stock, so that the program can be run.
    [[nodiscard]] bool hasStock() const;

private:
    [[nodiscard]] Result<Job> read() const;
    [[nodiscard]] Result<Job> readFiles() const;

    std::filesystem::path m_file;
    const CheckOptions& m_options;
    std::optional<std::filesystem::path> m_jobFile;
    FileState m_state;
    std::optional<Result<Job>> m_job;
};

} // namespace proveout::cli
