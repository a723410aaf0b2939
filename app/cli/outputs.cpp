// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/outputs.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <sys/stat.h>
#include <system_error>

#include "core/base/atomic_file.h"
#include "core/base/memory.h"
#include "core/verification/findings/command_line_findings.h"

namespace proveout::cli {

namespace {

Result<void> checkDistinct(const std::vector<std::string>& inputs, const std::vector<Output>& outputs) {
    std::vector<std::filesystem::path> taken;
    const auto resolved = [](const std::string& name) {
        std::error_code ignored;
        return std::filesystem::weakly_canonical(std::filesystem::absolute(name, ignored), ignored);
    };
    for (const auto& input : inputs)
        if (!input.empty())
            taken.push_back(resolved(input));
    for (const auto& [output, bytes] : outputs) {
        if (output.empty())
            continue;
        const auto path = resolved(output);
        if (std::ranges::find(taken, path) != taken.end())
            return failure(command_line_finding::kOutputOverwrites, {}, output);
        taken.push_back(path);
    }
    return {};
}

/// Each file fits alone. If the free space of a disk is unknown, it counts as sufficient.
Result<void> checkSpaceTogether(const std::vector<Output>& outputs) {
    std::map<dev_t, std::uint64_t> needed;
    for (const auto& [file, bytes] : outputs) {
        if (file.empty() || bytes == 0)
            continue;
        std::error_code error;
        const auto folder = std::filesystem::absolute(file, error).parent_path();
        struct stat info {};
        if (::stat(folder.c_str(), &info) != 0)
            continue;
        const std::uint64_t together = needed[info.st_dev] += bytes;
        const auto space = std::filesystem::space(folder, error);
        if (!error && space.capacity > 0 && together > space.available)
            return failure(command_line_finding::kOutputsLackSpace,
                           {readableBytes(static_cast<double>(together)),
                            readableBytes(static_cast<double>(space.available))},
                           file);
    }
    return {};
}

} // namespace

Result<void> checkOutputs(const std::vector<std::string>& inputs, const std::vector<Output>& outputs) {
    if (auto distinct = checkDistinct(inputs, outputs); !distinct)
        return distinct;
    for (const auto& [file, bytes] : outputs) {
        if (file.empty())
            continue;
        if (auto ready = AtomicFile(file, bytes).ready(); !ready)
            return ready;
    }
    return checkSpaceTogether(outputs);
}

bool writesFullMesh(const DecimationParameters& parameters) {
    return parameters.method == DecimationMethod::none || parameters.allowance <= 0;
}

Result<void> checkExportable(const DecimationParameters& parameters) {
    if (parameters.borders == BorderRule::shared || parameters.method == DecimationMethod::none)
        return {};
    return failure(command_line_finding::kBordersNotExported);
}

} // namespace proveout::cli
