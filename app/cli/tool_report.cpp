// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/tool_report.h"

#include <fmt/format.h>
#include <string>

namespace proveout::cli {

namespace {

std::string sourceText(const ToolOrigin& origin) {
    if (origin.source == ToolSource::assumed)
        return "assumed";
    return origin.line > 0 ? fmt::format("from the comment in line {}", origin.line) : "from a comment";
}

} // namespace

nlohmann::ordered_json toolsAsJson(const ToolTable& table) {
    auto list = nlohmann::ordered_json::array();
    for (const auto& [number, cutter] : table.tools()) {
        nlohmann::ordered_json row{{"number", number}, {"cutter", cutter.spec()}};
        const ToolOrigin* origin = table.unconfirmedOrigin(number);
        row["source"] = name(origin == nullptr ? ToolSource::given : origin->source);
        if (origin != nullptr && origin->line > 0)
            row.update(
                {{"line", origin->line}, {"comment", origin->comment}, {"defaults", origin->defaults}});
        if (origin != nullptr && !origin->entered.empty())
            row["entered"] = origin->entered;
        list.push_back(std::move(row));
    }
    return list;
}

void printTools(const ToolTable& table, bool unconfirmedOnly) {
    for (const auto& [number, cutter] : table.tools()) {
        const ToolOrigin* origin = table.unconfirmedOrigin(number);
        if (origin != nullptr)
            fmt::print("T{} {} ({}, not confirmed)\n", number, cutter.spec(), sourceText(*origin));
        else if (!unconfirmedOnly)
            fmt::print("T{} {}\n", number, cutter.spec());
    }
}

} // namespace proveout::cli
