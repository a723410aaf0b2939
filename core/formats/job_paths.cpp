// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/job_paths.h"

#include <algorithm>
#include <system_error>
#include <variant>

#include "core/formats/job_file.h"

namespace proveout {

namespace fs = std::filesystem;

bool anyOutside(const fs::path& /*file*/) {
    return true;
}

fs::path absolutePath(const fs::path& path) {
    std::error_code error;
    auto absolute = fs::weakly_canonical(fs::absolute(path, error), error);
    return error ? path : absolute;
}

fs::path folderOfJob(const fs::path& jobFile) {
    return absolutePath(jobFile).parent_path();
}

bool isOutside(const fs::path& folder, const fs::path& file) {
    return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first != folder.end();
}

std::vector<fs::path> filesOf(const Job& job) {
    std::vector<fs::path> files{job.program, job.setup.shape.file};
    for (const auto& named : job.setup.fixtures)
        if (const auto* mesh = std::get_if<FixtureMesh>(&named.second))
            files.push_back(mesh->file);
    if (job.part)
        files.push_back(job.part->file);
    std::erase_if(files, [](const fs::path& file) { return file.empty(); });
    return files;
}

std::vector<fs::path> outsideFiles(const fs::path& jobFile, const Job& job) {
    const fs::path folder = folderOfJob(jobFile);
    std::vector<fs::path> outside;
    for (const fs::path& named : filesOf(job)) {
        const fs::path file = absolutePath(named);
        if (isOutside(folder, file) && std::ranges::find(outside, file) == outside.end())
            outside.push_back(file);
    }
    return outside;
}

} // namespace proveout
