// SPDX-License-Identifier: GPL-3.0-or-later
// formats: lists the file formats of the table.
#include <fmt/core.h>
#include <memory>
#include <string>
#include <utility>

#include "app/cli/command.h"
#include "app/cli/report.h"
#include "core/formats/formats.h"

namespace proveout::cli {

namespace {

void printTable() {
    for (const FileFormat& format : fileFormats()) {
        std::string extensions;
        for (const char* extension : format.extensions)
            extensions += fmt::format("{}{}", extensions.empty() ? "" : " ", extension);
        const MeshFormat* mesh = format.meshWriter();
        fmt::print("{:<12} {:<12} {:<5} {:<6} {:<7} {}: {}\n", format.key, extensions,
                   format.reads() ? "reads" : "", format.writes() ? "writes" : "",
                   mesh != nullptr ? nameOf(mesh->coordinates) : "", format.label, format.holds);
    }
}

void printTableAsJson() {
    auto list = nlohmann::ordered_json::array();
    for (const FileFormat& format : fileFormats()) {
        nlohmann::ordered_json row{{"key", format.key},
                                   {"label", format.label},
                                   {"extensions", nlohmann::ordered_json::array()},
                                   {"reads", format.reads()},
                                   {"writes", format.writes()},
                                   {"holds", format.holds}};
        for (const char* extension : format.extensions)
            row["extensions"].push_back(extension);
        if (const MeshFormat* mesh = format.meshWriter(); mesh != nullptr)
            row["coordinates"] = nameOf(mesh->coordinates);
        list.push_back(std::move(row));
    }
    printJson({{"formats", std::move(list)}});
}

} // namespace

void addFormatsCommand(CLI::App& app, ExitCode& exitCode) {
    auto* command = app.add_subcommand("formats", "List the file formats");
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
