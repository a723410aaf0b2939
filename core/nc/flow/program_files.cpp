// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/flow/program_files.h"

#include <array>
#include <fmt/format.h>

namespace proveout {

std::vector<std::string> macroFileNames(int number, std::string_view name) {
    constexpr std::array kForms{"O{:04}", "o{:04}", "{:04}", "O{}", "o{}", "{}"};
    constexpr std::array kExtensions{"",     ".nc",  ".NC",  ".tap", ".TAP", ".cnc",
                                     ".CNC", ".txt", ".TXT", ".eia", ".EIA", ".ngc"};
    std::vector<std::string> names;
    if (!name.empty()) {
        for (const char* extension : kExtensions)
            names.push_back(std::string(name) + extension);
        return names;
    }
    for (const char* form : kForms) {
        for (const char* extension : kExtensions)
            names.push_back(fmt::format(fmt::runtime(form), number) + extension);
    }
    return names;
}

std::string subFileName(std::string_view label) {
    const bool plain = label.find_first_of("/\\") == std::string_view::npos && !label.starts_with('.');
    return plain ? std::string(label) + ".ngc" : std::string();
}

} // namespace proveout
