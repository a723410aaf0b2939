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
#include "core/nc/codes/codes.h"
#include "core/nc/codes/dialects.h"
#include "core/nc/run/lint.h"

namespace proveout::cli {

namespace {

using nlohmann::ordered_json;

/// As JSON names it, and as the list does.
struct MacroName {
    const char* key;
    const char* name;
};

MacroName nameOf(MacroLanguage language) {
    switch (language) {
    case MacroLanguage::macroB:
        return {"macroB", "custom macro B"};
    case MacroLanguage::labels:
        return {"labels", "parameters and labels"};
    case MacroLanguage::none:
        return {"none", "numbers only"};
    case MacroLanguage::oWords:
        break;
    }
    return {"oWords", "O-words"};
}

std::ptrdiff_t supportedCodes(const Dialect& dialect) {
    return std::ranges::count_if(codesOf(dialect.id).rows(),
                                 [](const CodeRow* row) { return row->supported(); });
}

ordered_json dialectsAsJson() {
    auto list = ordered_json::array();
    for (const Dialect& dialect : dialects()) {
        list.push_back({{"key", dialect.key},
                        {"name", dialect.name},
                        {"macros", nameOf(dialect.macros).key},
                        {"leastUnitMm", dialect.leastMm},
                        {"codes", supportedCodes(dialect)}});
    }
    return {{"dialects", std::move(list)}};
}

void printDialects() {
    for (const Dialect& dialect : dialects()) {
        fmt::print("{:<10} {:<14} {:>4} codes, {}, 1 without a point is {:g} mm\n", dialect.key, dialect.name,
                   supportedCodes(dialect), nameOf(dialect.macros).name, dialect.leastMm);
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
