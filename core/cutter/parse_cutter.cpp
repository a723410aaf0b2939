// SPDX-License-Identifier: GPL-3.0-or-later
// Parses `SHAPE:key=value,…` according to the table of shapes.
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <optional>

#include "core/base/figures_argument.h"
#include "core/base/tool_number.h"
#include "core/cutter/cutter_findings.h"
#include "core/cutter/shapes.h"
#include "core/cutter/tool_table.h"

namespace proveout {

namespace {

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Splits `text` at the first `separator` and returns the part before it; `text` keeps the rest.
std::string_view splitOff(std::string_view& text, char separator) {
    const auto at = text.find(separator);
    const std::string_view head = text.substr(0, at);
    text = at == std::string_view::npos ? std::string_view{} : text.substr(at + 1);
    return trimmed(head);
}

template<class Rows>
std::string listOf(const Rows& rows) {
    std::string names;
    for (const auto& row : rows)
        names += (names.empty() ? "" : ", ") + std::string(row.key);
    return names;
}

/// The keys of a shape and the values that were given for them.
struct KeyValues {
    std::vector<ShapeKey> keys;
    std::vector<std::optional<double>> given; ///< 0 for a value that is text
    std::string_view text;                    ///< of the key that is text

    explicit KeyValues(const CutterShape& shape) : keys(shape.keys.begin(), shape.keys.end()) {
        keys.insert(keys.end(), commonShapeKeys().begin(), commonShapeKeys().end());
        given.resize(keys.size());
    }

    [[nodiscard]] double value(std::size_t index) const {
        return given[index].value_or(keys[index].defaultValue);
    }
};

Result<double> parseNumber(const ShapeKey& key, std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        return failure(cutter_finding::kCutterValueNotANumber, {key.key, std::string(text)});
    if (value < key.minimum || value > key.maximum)
        return failure(
            cutter_finding::kCutterValueOutOfRange,
            {key.key, std::string(text), figures("{}", key.minimum), figures("{}", key.maximum), key.unit});
    return value;
}

Result<void> readValue(KeyValues& values, std::size_t index, std::string_view text) {
    if (values.keys[index].isText()) {
        values.given[index] = 0;
        values.text = text;
        return {};
    }
    auto value = parseNumber(values.keys[index], text);
    if (!value)
        return tl::unexpected(std::move(value.error()));
    values.given[index] = *value;
    return {};
}

Result<void> readAssignment(KeyValues& values, std::string_view assignment) {
    std::string_view text = assignment;
    const std::string_view name = splitOff(text, '=');
    for (std::size_t i = 0; i < values.keys.size(); ++i) {
        if (values.keys[i].key != name)
            continue;
        if (values.given[i])
            return failure(cutter_finding::kCutterKeyTwice, {std::string(name)});
        return readValue(values, i, trimmed(text));
    }
    return failure(cutter_finding::kCutterKeyUnknown, {std::string(name), listOf(values.keys)});
}

tl::unexpected<Diagnostics> keyMissing(const CutterShape& shape, const ShapeKey& key) {
    if (key.isText())
        return failure(cutter_finding::kCutterKeyMissing, {shape.key, key.key, key.label, key.defaultText});
    return failure(
        cutter_finding::kCutterKeyMissingRange,
        {shape.key, key.key, key.label, figures("{}", key.minimum), figures("{}", key.maximum), key.unit});
}

Result<KeyValues> readKeys(const CutterShape& shape, std::string_view text) {
    KeyValues values(shape);
    while (!text.empty()) {
        if (auto read = readAssignment(values, splitOff(text, ',')); !read)
            return tl::unexpected(std::move(read.error()));
    }
    for (std::size_t i = 0; i < values.keys.size(); ++i) {
        if (values.keys[i].required && !values.given[i])
            return keyMissing(shape, values.keys[i]);
    }
    return values;
}

const CutterShape* findShape(std::string_view name) {
    for (const CutterShape& shape : cutterShapes()) {
        if (shape.key == name)
            return &shape;
    }
    return nullptr;
}

/// The radius if none is given: that of the cutter, or of the neck of its head.
double shankRadiusOf(const CutterProfile& profile) {
    return profile.head ? profile.head->neckRadius : profile.pieces.back().r1;
}

} // namespace

Result<Cutter> parseCutter(std::string_view spec) {
    std::string_view text = trimmed(spec);
    const std::string_view name = splitOff(text, ':');
    const CutterShape* shape = findShape(name);
    if (shape == nullptr)
        return failure(cutter_finding::kCutterShapeUnknown, {std::string(name), listOf(cutterShapes())});
    const auto values = readKeys(*shape, text);
    if (!values)
        return tl::unexpected(values.error());

    const std::size_t own = shape->keys.size();
    std::vector<double> ownValues(own);
    for (std::size_t i = 0; i < own; ++i)
        ownValues[i] = values->value(i);
    auto profile = shape->profile({ownValues, values->text});
    if (!profile)
        return tl::unexpected(std::move(profile.error()));

    const double shankDiameter = values->value(own + 1);
    const double shankRadius = shankDiameter > 0 ? shankDiameter / 2 : shankRadiusOf(*profile);
    Cutter cutter(std::string(trimmed(spec)), std::move(*profile), values->value(own), shankRadius,
                  values->value(own + 2));
    if (!values->given[own] || *values->given[own] >= cutter.profileHeight())
        return cutter;
    return failure(cutter_finding::kFlutesTooShort,
                   {fmt::format("{}", *values->given[own]), figures("{:.4g}", cutter.profileHeight())});
}

Result<std::pair<int, Cutter>> parseToolOption(std::string_view option) {
    std::string_view spec = trimmed(option);
    std::string_view number = splitOff(spec, '=');
    if (!number.empty() && (number.front() == 'T' || number.front() == 't'))
        number.remove_prefix(1);
    const auto tool = parseToolNumber(number);
    if (!tool)
        return failure(cutter_finding::kToolNumberText, {std::string(option), std::to_string(kLeastTool),
                                                         std::to_string(kLargestTool), "1=ball:d=11,l=50"});
    auto cutter = parseCutter(spec);
    if (!cutter)
        return tl::unexpected(std::move(cutter.error()));
    return std::pair{*tool, std::move(*cutter)};
}

} // namespace proveout
