// SPDX-License-Identifier: GPL-3.0-or-later
// dialects, rules: list what the interpreter supports and which problems it reports, from the tables.
#include <algorithm>
#include <charconv>
#include <fmt/core.h>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/cli/command.h"
#include "app/cli/report.h"
#include "core/nc/codes/codes.h"
#include "core/nc/codes/dialects.h"
#include "core/verification/findings/exit_effect.h"
#include "core/verification/findings/findings.h"

namespace proveout::cli {

namespace {

using nlohmann::ordered_json;

/// The names in JSON and in the printed list.
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
        fmt::print("{:<10} {:<14} {:>4} codes, {}, 1 without a decimal point is {:g} mm\n", dialect.key,
                   dialect.name, supportedCodes(dialect), nameOf(dialect.macros).name, dialect.leastMm);
    }
}

/// The number of arguments of a sentence: the number of `{}`, or the largest n of `{n}`.
std::size_t parametersOf(std::string_view text) {
    std::size_t count = 0;
    std::size_t largest = 0;
    for (std::size_t at = text.find('{'); at != std::string_view::npos; at = text.find('{', at + 1)) {
        std::size_t number = 0;
        if (std::from_chars(text.data() + at + 1, text.data() + text.size(), number).ec == std::errc{})
            largest = std::max(largest, number);
        else
            ++count;
    }
    return std::max(count, largest);
}

ordered_json toJson(const FindingTable& table, const FindingRow& row) {
    ordered_json rule{{"id", row.id},
                      {"severity", name(row.severity)},
                      {"unverified", row.unverified},
                      {"exitCode", static_cast<int>(exitEffect(table, row))},
                      {"noticedBy", name(table.noticedBy)},
                      {"title", row.title},
                      {"text", row.text},
                      {"hint", row.hint},
                      {"parameters", parametersOf(row.text)}};
    if (row.severityRule == SeverityRule::warningIfAssumed)
        rule["severityIfAssumed"] = name(Severity::warning);
    if (row.severityRule == SeverityRule::worstOmitted)
        rule["severityAtMost"] = name(Severity::fault);
    return rule;
}

ordered_json rulesAsJson() {
    auto list = ordered_json::array();
    for (const FindingTable& table : findingTables())
        for (const FindingRow* row : table.rows)
            list.push_back(toJson(table, *row));
    return {{"rules", std::move(list)}};
}

/// Rows with the same id that differ only in their sentences share a line.
void printRules() {
    fmt::print("{:<32} {:<8} {:<5} {:<12} {}\n", "id", "severity", "exit", "noticed by", "title");
    std::set<std::string> printed;
    for (const FindingTable& table : findingTables())
        for (const FindingRow* row : table.rows) {
            const std::string line =
                fmt::format("{:<32} {:<8} {:<5} {:<12} {}", row->id, name(row->severity),
                            static_cast<int>(exitEffect(table, *row)), name(table.noticedBy), row->title);
            if (printed.insert(line).second)
                fmt::print("{}\n", line);
        }
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
    addListing(app, exitCode, "rules",
               "List everything that can be wrong, and the exit code that it leads to", printRules,
               rulesAsJson);
}

} // namespace proveout::cli
