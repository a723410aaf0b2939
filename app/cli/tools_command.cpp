// SPDX-License-Identifier: GPL-3.0-or-later
// tools: the shapes of cutters with their keys, or the tools of a table.
#include <algorithm>
#include <cstddef>
#include <fmt/core.h>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/report.h"
#include "app/cli/tool_report.h"
#include "core/cutter/shapes.h"
#include "core/cutter/tool_file.h"

namespace proveout::cli {

namespace {

struct ToolsOptions {
    std::string file;
    bool shapes = false;
    bool json = false;
};

void printKey(const ShapeKey& key) {
    if (key.isText()) {
        fmt::print("  {:<7} {}, e.g. {} ({})\n", key.key, key.label, key.exampleText(),
                   key.required ? "required" : "none");
        return;
    }
    const std::string unit = (*key.unit == '\0' ? "" : " ") + std::string(key.unit);
    const std::string defaultText =
        key.required ? std::string("required") : fmt::format("{}{}", key.defaultValue, unit);
    fmt::print("  {:<7} {}: {} to {}{} ({})\n", key.key, key.label, key.minimum, key.maximum, unit,
               defaultText);
}

/// Its own keys, and those of every shape that have another default.
std::vector<ShapeKey> listedKeys(const CutterShape& shape) {
    std::vector<ShapeKey> keys = keysOf(shape);
    const auto common = keys.begin() + static_cast<std::ptrdiff_t>(shape.keys.size());
    const auto isCommon = [](const ShapeKey& key) {
        return std::ranges::any_of(commonShapeKeys(), [&](const ShapeKey& row) {
            return std::string_view(row.key) == key.key && row.defaultValue == key.defaultValue;
        });
    };
    keys.erase(std::remove_if(common, keys.end(), isCommon), keys.end());
    return keys;
}

void printShapes() {
    for (const CutterShape& shape : cutterShapes()) {
        fmt::print("{}: {}\n", shape.key, shape.label);
        for (const ShapeKey& key : listedKeys(shape))
            printKey(key);
    }
    fmt::print("Every shape:\n");
    for (const ShapeKey& key : commonShapeKeys())
        printKey(key);
}

nlohmann::ordered_json toJson(std::span<const ShapeKey> keys) {
    auto list = nlohmann::ordered_json::array();
    for (const ShapeKey& key : keys) {
        nlohmann::ordered_json row{{"key", key.key}, {"label", key.label}};
        if (key.isText())
            row.update({{"standard", key.defaultText}, {"example", key.exampleText()}});
        else
            row.update({{"unit", key.unit},
                        {"minimum", key.minimum},
                        {"maximum", key.maximum},
                        {"standard", key.defaultValue}});
        row["required"] = key.required;
        list.push_back(std::move(row));
    }
    return list;
}

nlohmann::ordered_json shapesAsJson() {
    auto list = nlohmann::ordered_json::array();
    for (const CutterShape& shape : cutterShapes())
        list.push_back({{"key", shape.key}, {"label", shape.label}, {"keys", toJson(listedKeys(shape))}});
    return list;
}

ExitCode run(const ToolsOptions& options) {
    Report report(options.file);
    nlohmann::ordered_json object;
    if (options.shapes && options.json)
        object = {{"shapes", shapesAsJson()}, {"everyShape", toJson(commonShapeKeys())}};
    else if (options.shapes)
        printShapes();
    if (!options.file.empty()) {
        auto table = readToolFile(options.file);
        if (!table)
            report.addFatal(std::move(table.error()));
        else if (options.json)
            object["tools"] = toolsAsJson(*table);
        else
            printTools(*table, false);
    }
    if (options.json) {
        object["findings"] = report.findings();
        printJson(object);
    }
    return report.exitCode();
}

} // namespace

void addToolsCommand(CLI::App& app, ExitCode& exitCode) {
    auto* command = app.add_subcommand("tools", "List the cutter shapes, or the tools of a table");
    auto options = std::make_shared<ToolsOptions>();
    command->add_option("FILE", options->file, "Tool table (TOML): print its tools")->type_name("");
    command->add_flag("--shapes", options->shapes, "Print the shapes and their keys, for --tool");
    command->add_flag("--json", options->json, "Print one JSON object");
    command->callback([options, &exitCode] {
        if (options->file.empty() && !options->shapes)
            throw CLI::RequiredError("FILE or --shapes");
        exitCode = run(*options);
    });
}

} // namespace proveout::cli
