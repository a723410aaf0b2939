// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "core/base/diagnostic.h"
#include "core/base/utf8.h"
#include "tests/bench/faults/fault_cases.h"

namespace proveout {

namespace {

constexpr std::size_t kLongestSentence = 110;

std::string beginning(const std::string& text, std::size_t bytes) {
    return text.size() <= bytes ? text : std::string(shortened(text, bytes)) + "…";
}

} // namespace

std::string shownName(const FaultCase& fault) {
    Diagnostic named;
    named.file = fault.name;
    const std::string line = oneLine(named); // escapes the names in it
    return fmt::format("{} | {}", fault.number == 0 ? "–" : std::to_string(fault.number),
                       beginning(line.substr(0, line.find(": ")), 30));
}

std::string shortened(const std::string& message, const std::filesystem::path& folder) {
    std::string text = message;
    for (const std::string& prefix : {folder.string() + "/", std::string("./")})
        if (text.starts_with(prefix))
            text.erase(0, prefix.size());
    const std::size_t id = text.rfind(" [");
    if (id == std::string::npos || id <= kLongestSentence)
        return text;
    return beginning(text.substr(0, id), kLongestSentence) + text.substr(id);
}

std::string leadingMessage(const std::vector<std::string>& messages) {
    static constexpr std::array kOrder{": error: ", ": fault: ", ": warning: ", ": note: "};
    for (const char* severity : kOrder) {
        const auto found = std::ranges::find_if(messages, [severity](const std::string& message) {
            return message.find(severity) != std::string::npos;
        });
        if (found != messages.end())
            return *found;
    }
    return messages.empty() ? "(none)" : messages.front();
}

void printFaultsElsewhere() {
    fmt::print("\n| # | elsewhere | covered by |\n|--:|:--|:--|\n");
    for (const FaultElsewhere& one : faultsElsewhere())
        fmt::print("| {} | {} | {} |\n", one.number, one.what,
                   *one.test == '\0' ? "**not covered**" : one.test);
}

} // namespace proveout
