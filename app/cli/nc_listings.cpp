// SPDX-License-Identifier: GPL-3.0-or-later
// dialects, rules: what the interpreter knows, read from its tables.
#include <algorithm>
#include <fmt/core.h>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/report.h"
#include "core/nc/codes.h"
#include "core/nc/dialect.h"
#include "core/nc/lint.h"

namespace proveout::cli {

namespace {

using nlohmann::ordered_json;

ordered_json dialectsAsJson() {
    auto list = ordered_json::array();
    for (const Dialect& dialect : dialects()) {
        const auto rows = codesOf(dialect.id).rows();
        const auto supported =
            std::ranges::count_if(rows, [](const CodeRow* row) { return row->supported(); });
        list.push_back({{"key", dialect.key},
                        {"name", dialect.name},
                        {"macros", dialect.macros == MacroLanguage::macroB ? "macroB" : "oWords"},
                        {"leastUnitMm", dialect.leastMm},
                        {"codes", supported}});
    }
    return {{"dialects", std::move(list)}};
}

void printDialects() {
    const ordered_json all = dialectsAsJson();
    for (const auto& row : all["dialects"]) {
        fmt::print("{:<10} {:<10} {:>4} codes, {}, 1 without a point is {:g} mm\n",
                   row["key"].get<std::string>(), row["name"].get<std::string>(), row["codes"].get<int>(),
                   row["macros"] == "macroB" ? "custom macro B" : "O-words",
                   row["leastUnitMm"].get<double>());
    }
}

/// Every rule once, though it may look at several moments.
std::vector<const Message*> rules() {
    std::vector<const Message*> messages;
    for (const LintRule& rule : lintRules()) {
        if (std::ranges::find(messages, rule.message) == messages.end())
            messages.push_back(rule.message);
    }
    return messages;
}

std::string_view nameOf(Severity severity) {
    switch (severity) {
    case Severity::note:
        return "note";
    case Severity::warning:
        return "warning";
    default:
        return "error";
    }
}

ordered_json rulesAsJson() {
    auto list = ordered_json::array();
    for (const Message* rule : rules())
        list.push_back({{"id", rule->id},
                        {"severity", nameOf(rule->severity)},
                        {"text", rule->text},
                        {"hint", rule->hint}});
    return {{"rules", std::move(list)}};
}

void printRules() {
    for (const Message* rule : rules())
        fmt::print("{:<22} {:<8} {}\n", rule->id, nameOf(rule->severity), rule->text);
}

void addListing(CLI::App& app, ExitCode& exitCode, const char* name, const char* description, void (*print)(),
                ordered_json (*asJson)()) {
    auto* command = app.add_subcommand(name, description);
    auto json = std::make_shared<bool>(false);
    command->add_flag("--json", *json, "Print one JSON object");
    command->callback([json, print, asJson, &exitCode] {
        if (*json)
            printJson(asJson());
        else
            print();
        exitCode = ExitCode::done;
    });
}

} // namespace

void addNcListings(CLI::App& app, ExitCode& exitCode) {
    addListing(app, exitCode, "dialects", "List the dialects of NC programs", printDialects, dialectsAsJson);
    addListing(app, exitCode, "rules", "List the rules for what is seldom meant", printRules, rulesAsJson);
}

} // namespace proveout::cli
