// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes `SHAPE:key=value,…` according to the table of stock shapes.
#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <set>
#include <utility>
#include <vector>

#include "core/base/figures_argument.h"
#include "core/formats/stock_file_findings.h"
#include "core/formats/stock_shapes.h"

namespace proveout {

namespace {

struct KeyAndValue {
    const StockField* field;
    std::string value;
};

template<class Rows>
std::string listOf(const Rows& rows) {
    std::string names;
    for (const auto& row : rows)
        names += (names.empty() ? "" : ", ") + std::string(row.key);
    return names;
}

const StockField* fieldOf(const StockShapeRow& row, std::string_view key) {
    const auto found =
        std::ranges::find_if(row.fields, [&](const StockField& field) { return field.key == key; });
    return found == row.fields.end() ? nullptr : &*found;
}

tl::unexpected<Diagnostics> unknownKey(const StockShapeRow& row, std::string_view part) {
    return failure(stock_finding::kStockKeyUnknown,
                   {std::string(part.substr(0, part.find('='))), listOf(row.fields)});
}

/// A part that does not begin with a key belongs to the file name before it, which contained a comma.
Result<std::vector<KeyAndValue>> split(const StockShapeRow& row, std::string_view text) {
    std::vector<KeyAndValue> out;
    while (!text.empty()) {
        const auto comma = text.find(',');
        const std::string_view part = text.substr(0, comma);
        text = comma == std::string_view::npos ? std::string_view() : text.substr(comma + 1);
        const auto equals = part.find('=');
        const StockField* field =
            equals == std::string_view::npos ? nullptr : fieldOf(row, part.substr(0, equals));
        const bool inFileName = !out.empty() && std::holds_alternative<StockFile>(out.back().field->value);
        if (field != nullptr)
            out.push_back({field, std::string(part.substr(equals + 1))});
        else if (inFileName)
            out.back().value.append(",").append(part);
        else
            return unknownKey(row, part);
    }
    return out;
}

Result<void> readLength(const StockField& field, const StockLength& length, std::string_view text,
                        StockSpec& spec) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() ||
        !(value > kLeastStockSide && value <= kLargestStockSide))
        return failure(
            stock_finding::kStockValueBad,
            {field.key, std::string(text), figures("{}", kLeastStockSide), figures("{}", kLargestStockSide)});
    length.set(spec, value);
    return {};
}

Result<void> readChoice(const StockField& field, const StockChoice& choice, std::string_view text,
                        StockSpec& spec) {
    const auto found =
        std::ranges::find_if(choice.choices, [&](const Choice& row) { return row.key == text; });
    if (found == choice.choices.end())
        return failure(stock_finding::kStockChoiceUnknown,
                       {field.key, std::string(text), listOf(choice.choices)});
    choice.set(spec, static_cast<std::size_t>(found - choice.choices.begin()));
    return {};
}

Result<void> read(const KeyAndValue& assignment, StockSpec& spec) {
    const StockField& field = *assignment.field;
    if (const auto* length = std::get_if<StockLength>(&field.value))
        return readLength(field, *length, assignment.value, spec);
    if (const auto* choice = std::get_if<StockChoice>(&field.value))
        return readChoice(field, *choice, assignment.value, spec);
    if (assignment.value.empty())
        return failure(stock_finding::kStockFileMissing, {field.key});
    spec.shape.file = assignment.value;
    return {};
}

Result<StockSpec> parseShape(const StockShapeRow& row, std::string_view text) {
    StockSpec spec;
    spec.shape.kind = row.kind;
    const auto assignments = split(row, text);
    if (!assignments)
        return tl::unexpected(assignments.error());
    std::set<const StockField*> given;
    for (const KeyAndValue& assignment : *assignments) {
        if (!given.insert(assignment.field).second)
            return failure(stock_finding::kStockKeyTwice, {assignment.field->key});
        if (auto fine = read(assignment, spec); !fine)
            return tl::unexpected(std::move(fine.error()));
    }
    for (const StockField& field : row.fields)
        if (!given.contains(&field) && !std::holds_alternative<StockChoice>(field.value))
            return failure(stock_finding::kStockKeyMissing, {row.key, field.key, row.example});
    return spec;
}

} // namespace

Result<StockSpec> parseStock(std::string_view text) {
    const auto colon = text.find(':');
    if (colon != std::string_view::npos) {
        const std::string_view key = text.substr(0, colon);
        for (const StockShapeRow& row : stockShapes())
            if (row.key == key)
                return parseShape(row, text.substr(colon + 1));
        return failure(stock_finding::kStockShapeUnknown, {std::string(key), listOf(stockShapes())});
    }
    const auto sides = parseStockSize(text);
    if (!sides)
        return tl::unexpected(sides.error());
    StockSpec spec;
    spec.box.width = sides->x;
    spec.box.depth = sides->y;
    spec.box.height = sides->z;
    return spec;
}

std::string stockText(const StockSpec& spec) {
    if (spec.shape.kind == StockKind::box)
        return fmt::format("{}x{}x{}", spec.box.width, spec.box.depth, spec.box.height);
    const StockShapeRow& row = rowOf(spec.shape.kind);
    std::string text = row.key;
    char before = ':';
    for (const StockField& field : row.fields) {
        std::string value;
        if (const auto* length = std::get_if<StockLength>(&field.value))
            value = fmt::format("{}", length->get(spec));
        else if (const auto* choice = std::get_if<StockChoice>(&field.value))
            value = choice->choices[choice->get(spec)].key;
        else
            value = spec.shape.file.string();
        text += fmt::format("{}{}={}", before, field.key, value);
        before = ',';
    }
    return text;
}

} // namespace proveout
