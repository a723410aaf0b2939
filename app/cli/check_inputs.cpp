// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/check_inputs.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace proveout::cli {

namespace fs = std::filesystem;

namespace {

constexpr std::array<std::string_view, 11> kEndings{".nc",  ".ngc", ".cnc", ".tap", ".gcode",   ".iso",
                                                    ".min", ".mpf", ".eia", ".gc",  ".proveout"};

std::string endingOf(const fs::path& file) {
    std::string ending = file.extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return ending;
}

} // namespace

bool isJob(const fs::path& file) {
    return endingOf(file) == ".proveout";
}

std::vector<fs::path> filesToCheck(const std::vector<std::string>& inputs) {
    std::vector<fs::path> files;
    for (const std::string& input : inputs) {
        std::error_code error;
        if (!fs::is_directory(input, error)) {
            files.emplace_back(input);
            continue;
        }
        std::vector<fs::path> inside;
        constexpr auto kOptions = fs::directory_options::skip_permission_denied;
        for (fs::recursive_directory_iterator each(input, kOptions, error), end; each != end;
             each.increment(error)) {
            std::error_code ofEntry;
            if (each->is_regular_file(ofEntry) &&
                std::ranges::find(kEndings, endingOf(each->path())) != kEndings.end())
                inside.push_back(each->path());
        }
        std::ranges::sort(inside);
        files.insert(files.end(), inside.begin(), inside.end());
    }
    return files;
}

} // namespace proveout::cli
