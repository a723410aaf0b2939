// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/job_paths.h"

#include <algorithm>
#include <system_error>

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

std::vector<fs::path> outsideFiles(const fs::path& jobFile, const Job& job) {
    const fs::path folder = folderOfJob(jobFile);
    std::vector<fs::path> outside;
    for (const fs::path& named : {job.program, job.setup.shape.file}) {
        const fs::path file = named.empty() ? fs::path() : absolutePath(named);
        if (!file.empty() && isOutside(folder, file) && std::ranges::find(outside, file) == outside.end())
            outside.push_back(file);
    }
    return outside;
}

} // namespace proveout
