// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/outputs.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace proveout::cli {

Result<void> checkOutputs(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs) {
    std::vector<std::filesystem::path> taken;
    const auto resolved = [](const std::string& name) {
        std::error_code ignored;
        return std::filesystem::weakly_canonical(std::filesystem::absolute(name, ignored), ignored);
    };
    for (const auto& input : inputs)
        if (!input.empty())
            taken.push_back(resolved(input));
    for (const auto& output : outputs) {
        if (output.empty())
            continue;
        const auto path = resolved(output);
        if (std::ranges::find(taken, path) != taken.end())
            return failure("output-overwrites", "This output would overwrite an input or another output.", {},
                           output);
        taken.push_back(path);
    }
    return {};
}

Result<void> checkExportable(const DecimationParameters& parameters) {
    if (parameters.borders == BorderRule::shared || parameters.method == DecimationMethod::none)
        return {};
    return failure("borders-not-exported",
                   "Borders decimated per region leave cracks: they are for studies and "
                   "are not exported.");
}

} // namespace proveout::cli
