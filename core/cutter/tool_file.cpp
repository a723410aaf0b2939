// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutter/tool_file.h"

#include <cstdint>
#include <limits>
#include <string>
#include <toml++/toml.h>
#include <utility>

#include "core/base/atomic_file.h"
#include "core/base/text.h"

namespace proveout {

namespace {

/// A tool table is written by hand; a longer file is not one.
constexpr std::uint64_t kMaxBytes = 10'000'000;

TextRange place(const toml::source_region& region) {
    return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column), 0};
}

Result<void> readRow(const toml::table& row, ToolTable& tools) {
    const auto number = row["number"].value_exact<std::int64_t>();
    if (!number || *number < 1 || *number > std::numeric_limits<int>::max())
        return failure("tool-number", PROVEOUT_TEXT("Core", "A tool needs a number, a whole one from 1 on."));
    if (tools.find(static_cast<int>(*number)) != nullptr)
        return failure("tool-twice", PROVEOUT_TEXT("Core", "Tool {} stands in the table twice."),
                       {std::to_string(*number)});
    const auto spec = row["cutter"].value_exact<std::string>();
    if (!spec)
        return failure("tool-cutter",
                       PROVEOUT_TEXT("Core", "Tool {} needs a cutter, e.g. cutter = \"ball:d=11,l=50\"."),
                       {std::to_string(*number)});
    auto cutter = parseCutter(*spec);
    if (!cutter)
        return tl::unexpected(std::move(cutter.error()));
    tools.set(static_cast<int>(*number), std::move(*cutter));
    return {};
}

Result<ToolTable> readRows(const toml::table& document) {
    ToolTable tools;
    const auto* rows = document["tool"].as_array();
    if (rows == nullptr)
        return failure("tool-file-empty", PROVEOUT_TEXT("Core", "The file holds no [[tool]] tables."));
    for (const toml::node& node : *rows) {
        const auto* row = node.as_table();
        auto read = row == nullptr
                        ? failure("tool-row", PROVEOUT_TEXT("Core", "A tool must be a table: [[tool]]."))
                        : readRow(*row, tools);
        if (!read) {
            for (Diagnostic& diagnostic : read.error())
                diagnostic.where = place(node.source());
            return tl::unexpected(std::move(read.error()));
        }
    }
    return tools;
}

} // namespace

Result<ToolTable> readToolFile(const std::filesystem::path& file) {
    const auto bytes = readFile(file, kMaxBytes);
    if (!bytes)
        return tl::unexpected(bytes.error());
    Result<ToolTable> tools;
    try {
        tools = readRows(toml::parse(*bytes));
    } catch (const toml::parse_error& error) {
        tools = failure("tool-file-syntax", PROVEOUT_TEXT("Core", "The tool table cannot be read: {}."),
                        {std::string(error.description())});
        tools.error().front().where = place(error.source());
    }
    if (!tools)
        for (Diagnostic& diagnostic : tools.error())
            diagnostic.file = file.string();
    return tools;
}

} // namespace proveout
