// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutter/tool_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fmt/format.h>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <toml++/toml.h>
#include <utility>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/base/bounded_diagnostics.h"
#include "core/base/nearest_name.h"
#include "core/base/tool_number.h"
#include "core/cutter/cutter_findings.h"

namespace proveout {

namespace {

/// A tool table is written by hand; a longer file is not one.
constexpr std::uint64_t kMaxBytes = 10'000'000;

constexpr std::array<std::string_view, 1> kTables{"tool"};
constexpr std::array<std::string_view, 3> kRowKeys{"number", "cutter", "source"};

TextRange place(const toml::source_region& region) {
    return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column), 0};
}

/// Reads the rows; errors are reported at their places.
class RowReader {
public:
    Result<ToolTable> read(const toml::table& document) {
        refuseUnknown(document, kTables, cutter_finding::kToolKeyUnknownTable,
                      cutter_finding::kToolKeyUnknownTableMeant);
        const auto* rows = document["tool"].as_array();
        if (rows == nullptr)
            fail({}, cutter_finding::kToolFileEmpty);
        else
            for (const toml::node& row : *rows)
                readNode(row);
        if (m_errors.empty())
            return std::move(m_tools);
        m_errors.sortByPlace();
        return tl::unexpected(m_errors.take());
    }

private:
    void readNode(const toml::node& node) {
        const auto* row = node.as_table();
        if (row == nullptr) {
            fail(place(node.source()), cutter_finding::kToolRow);
            return;
        }
        refuseUnknown(*row, kRowKeys, cutter_finding::kToolKeyUnknown, cutter_finding::kToolKeyUnknownMeant);
        if (const auto number = readNumber(*row))
            readCutter(*row, *number);
    }

    /// Nothing if the row has no usable number.
    std::optional<int> readNumber(const toml::table& row) {
        const auto number = row["number"].value_exact<std::int64_t>();
        if (!number || *number < kLeastTool || *number > kLargestTool) {
            fail(placeOf(row, "number"), cutter_finding::kToolNumber,
                 {std::to_string(kLeastTool), std::to_string(kLargestTool)});
            return {};
        }
        if (!m_numbers.insert(*number).second) {
            fail(placeOf(row, "number"), cutter_finding::kToolTwice, {std::to_string(*number)});
            return {};
        }
        return static_cast<int>(*number);
    }

    void readCutter(const toml::table& row, int number) {
        const auto spec = row["cutter"].value_exact<std::string>();
        if (!spec) {
            fail(placeOf(row, "cutter"), cutter_finding::kToolCutter, {std::to_string(number)});
            return;
        }
        auto cutter = parseCutter(*spec);
        if (cutter) {
            m_tools.set(number, std::move(*cutter), {readSource(row)});
            return;
        }
        for (Diagnostic& error : cutter.error()) {
            error.where = placeOf(row, "cutter");
            m_errors.add(std::move(error));
        }
    }

    ToolSource readSource(const toml::table& row) {
        if (!row.contains("source"))
            return ToolSource::given;
        const auto named = row["source"].value_exact<std::string>();
        for (const ToolSource source : {ToolSource::given, ToolSource::comment, ToolSource::assumed})
            if (named == name(source))
                return source;
        fail(placeOf(row, "source"), cutter_finding::kToolSource);
        return ToolSource::given;
    }

    /// A misspelt key must not be ignored silently.
    void refuseUnknown(const toml::table& table, std::span<const std::string_view> names,
                       const FindingRow& listing, const FindingRow& guessing) {
        for (const auto& [key, value] : table) {
            if (std::ranges::find(names, key.str()) != names.end())
                continue;
            const std::string_view meant = nearestName(key.str(), names);
            fail(place(key.source()), meant.empty() ? listing : guessing,
                 {std::string(key.str()),
                  meant.empty() ? fmt::format("{}", fmt::join(names, ", ")) : std::string(meant)});
        }
    }

    /// The place of the value, or of the row if the key is missing.
    static TextRange placeOf(const toml::table& row, std::string_view key) {
        const toml::node* value = row.get(key);
        return place(value == nullptr ? row.source() : value->source());
    }

    void fail(TextRange where, const FindingRow& row, std::vector<Argument> arguments = {}) {
        Diagnostic error = diagnosticOf(row, std::move(arguments));
        error.where = where;
        m_errors.add(std::move(error));
    }

    ToolTable m_tools;
    std::set<std::int64_t> m_numbers; ///< of all rows read, including those without a cutter
    BoundedDiagnostics m_errors;
};

} // namespace

Result<ToolTable> readToolFile(const std::filesystem::path& file) {
    const auto bytes = readFile(file, kMaxBytes);
    if (!bytes)
        return tl::unexpected(bytes.error());
    Result<ToolTable> tools;
    try {
        tools = RowReader().read(toml::parse(*bytes));
    } catch (const toml::parse_error& error) {
        tools = failure(cutter_finding::kToolFileSyntax, {std::string(error.description())});
        tools.error().front().where = place(error.source());
    }
    if (!tools)
        for (Diagnostic& diagnostic : tools.error())
            diagnostic.file = file.string();
    return tools;
}

} // namespace proveout
