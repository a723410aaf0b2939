// SPDX-License-Identifier: GPL-3.0-or-later
// stocks: lists the stock shapes of the table.
#include <fmt/core.h>
#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "app/cli/command.h"
#include "app/cli/report.h"
#include "core/formats/stock_shapes.h"

namespace proveout::cli {

namespace {

/// The permitted values of the key.
std::string valuesOf(const StockField& field) {
    if (std::holds_alternative<StockLength>(field.value))
        return fmt::format("above {} to {} mm", kLeastStockSide, kLargestStockSide);
    if (const auto* file = std::get_if<StockFile>(&field.value))
        return file->filter;
    std::string keys;
    for (const Choice& choice : std::get<StockChoice>(field.value).choices)
        keys += fmt::format("{}{}", keys.empty() ? "" : ", ", choice.key);
    return keys;
}

void printTable() {
    for (const StockShapeRow& row : stockShapes()) {
        fmt::print("{}: {}. {} E.g. {}\n", row.key, row.label, row.help, row.example);
        for (const StockField& field : row.fields)
            fmt::print("  {:<6} {}: {} ({})\n", field.key, field.label, field.help, valuesOf(field));
    }
}

void printTableAsJson() {
    auto list = nlohmann::ordered_json::array();
    for (const StockShapeRow& row : stockShapes()) {
        auto keys = nlohmann::ordered_json::array();
        for (const StockField& field : row.fields)
            keys.push_back({{"key", field.key},
                            {"job", field.name},
                            {"label", field.label},
                            {"values", valuesOf(field)},
                            {"required", !std::holds_alternative<StockChoice>(field.value)}});
        list.push_back({{"key", row.key}, {"label", row.label}, {"example", row.example}, {"keys", keys}});
    }
    printJson({{"stocks", std::move(list)}});
}

} // namespace

void addStocksCommand(CLI::App& app, ExitCode& exitCode) {
    auto* command = app.add_subcommand("stocks", "List the stock shapes and their keys, for --stock");
    auto json = std::make_shared<bool>(false);
    command->add_flag("--json", *json, "Print one JSON object");
    command->callback([json, &exitCode] {
        if (*json)
            printTableAsJson();
        else
            printTable();
        exitCode = ExitCode::done;
    });
}

} // namespace proveout::cli
