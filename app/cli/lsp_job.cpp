// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/lsp_job.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/cli/check_inputs.h"
#include "core/base/atomic_file.h"
#include "core/formats/job_paths.h"

namespace proveout::cli {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostJobs = 100;
constexpr std::uint64_t kLargestJob = 1'000'000; ///< bytes

/// Whether a job file names the program, whatever else is in it.
bool namesProgram(const fs::path& jobFile, const fs::path& program) {
    const auto bytes = readFile(jobFile, kLargestJob);
    if (!bytes)
        return false;
    // Only the member "program" of the outermost object is kept.
    const auto keep = [](int depth, nlohmann::json::parse_event_t event, const nlohmann::json& value) {
        const bool key = event == nlohmann::json::parse_event_t::key;
        return depth < 1 || (depth == 1 && (!key || value == "program"));
    };
    const auto job = nlohmann::json::parse(*bytes, keep, false);
    if (!job.is_object() || !job.contains("program") || !job["program"].is_string())
        return false;
    return absolutePath(folderOfJob(jobFile) / job["program"].get<std::string>()) == program;
}

} // namespace

std::optional<fs::path> jobBeside(const fs::path& program) {
    if (program.empty())
        return {};
    std::vector<fs::path> jobs;
    std::error_code error;
    for (fs::directory_iterator each(program.parent_path(), error), end; !error && each != end;
         each.increment(error)) {
        std::error_code ofEntry;
        if (isJob(each->path()) && each->is_regular_file(ofEntry))
            jobs.push_back(each->path());
    }
    const auto rank = [&](const fs::path& job) { return std::pair(job.stem() != program.stem(), job); };
    std::ranges::sort(jobs, {}, rank);
    jobs.resize(std::min(jobs.size(), kMostJobs));
    const fs::path absolute = absolutePath(program);
    const auto found =
        std::ranges::find_if(jobs, [&](const fs::path& job) { return namesProgram(job, absolute); });
    return found == jobs.end() ? std::nullopt : std::optional(*found);
}

void LspJob::refresh() {
    m_jobFile = jobBeside(m_file);
    m_job.reset();
}

Result<Job> LspJob::job() {
    const FileState state = m_jobFile ? stateOf(*m_jobFile) : FileState();
    if (!m_job || state != m_state) {
        m_state = state;
        m_job = read();
    }
    return *m_job;
}

Result<Job> LspJob::read() const {
    auto job = readFiles();
    if (job)
        if (auto judged = m_options.settings.apply(job->check); !judged)
            return tl::unexpected(std::move(judged.error()));
    return job;
}

Result<Job> LspJob::readFiles() const {
    if (m_jobFile)
        return m_options.setup.jobOf(m_jobFile->string(), true);
    // A document without a file has subprograms nowhere.
    auto job = m_options.setup.jobOf(m_file.empty() ? "untitled" : m_file.string(), false);
    if (job && m_file.empty())
        job->program.clear();
    return job;
}

Job LspJob::fallback() const {
    Job job;
    job.program = m_file;
    return job;
}

bool LspJob::hasStock() const {
    return m_jobFile || m_options.setup.stockGiven();
}

} // namespace proveout::cli
