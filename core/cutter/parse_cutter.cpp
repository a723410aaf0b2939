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
    std::vector<std::string_view> texts;      ///< by key; empty for a value that is a number
    std::size_t own; ///< the number of keys that only this shape has; they come first

    explicit KeyValues(const CutterShape& shape) : keys(keysOf(shape)), own(shape.keys.size()) {
        given.resize(keys.size());
        texts.resize(keys.size());
    }

    [[nodiscard]] double value(std::size_t index) const {
        return given[index].value_or(keys[index].defaultValue);
    }
    /// The value of a key by its name; 0 if the shape has no such key.
    [[nodiscard]] double value(std::string_view name) const {
        for (std::size_t i = 0; i < keys.size(); ++i)
            if (name == keys[i].key)
                return value(i);
        return 0;
    }
    /// The text of the one key of the shape itself that has one.
    [[nodiscard]] std::string_view ownText() const {
        for (std::size_t i = 0; i < own; ++i)
            if (keys[i].isText())
                return texts[i];
        return {};
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
    if (key.whole && value != std::floor(value))
        return failure(cutter_finding::kCutterValueNotWhole, {key.key, std::string(text)});
    return value;
}

Result<void> readValue(KeyValues& values, std::size_t index, std::string_view text) {
    if (values.keys[index].isText()) {
        values.given[index] = 0;
        values.texts[index] = text;
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

/// The keys that every shape has, in the order of commonShapeKeys().
enum CommonKey : std::size_t { kFlutes, kShankDiameter, kShankLength, kStickOut, kHolder };

Result<ToolBody> readBody(const KeyValues& values, const CutterProfile& profile) {
    const auto number = [&](CommonKey key) { return values.value(values.own + key); };
    ToolBody body;
    body.fluteLength = number(kFlutes);
    body.shankGiven = number(kShankDiameter) > 0;
    body.shankRadius = body.shankGiven ? number(kShankDiameter) / 2 : shankRadiusOf(profile);
    body.shankLength = number(kShankLength);
    body.stickOut = number(kStickOut);
    if (!values.given[values.own + kHolder])
        return body;
    auto holder = parseHolder(values.texts[values.own + kHolder]);
    if (!holder)
        return tl::unexpected(std::move(holder.error()));
    if (body.stickOut == 0)
        return failure(cutter_finding::kHolderWithoutStickOut);
    body.holder = std::move(*holder);
    return body;
}

Result<CuttingData> readData(const KeyValues& values) {
    CuttingData data;
    data.teeth = static_cast<int>(values.value("z"));
    data.centreCutting = values.value("centre") > 0;
    data.steepestRamp = values.value("ramp");
    data.pitch = values.value("pitch");
    data.mostDepth = values.value("maxap");
    data.mostEngagement = values.value("maxae");
    data.mostChip = values.value("maxchip");
    data.mostSpindle = values.value("maxrpm");
    data.mostFeed = values.value("maxfeed");
    data.mostSurfaceSpeed = values.value("maxvc");
    data.mostRemoval = values.value("maxmrr");
    if (data.mostChip > 0 && data.teeth == 0)
        return failure(cutter_finding::kChipWithoutTeeth);
    return data;
}

/// The flutes, if they were given, and the stick-out reach to the top of the profile at least.
Result<void> checkLengths(const KeyValues& values, const Cutter& cutter) {
    const auto refuse = [&](const FindingRow& row, double length) {
        return failure(row, {fmt::format("{}", length), figures("{:.4g}", cutter.profileHeight())});
    };
    const std::optional<double> flutes = values.given[values.own + kFlutes];
    if (flutes && *flutes < cutter.profileHeight())
        return refuse(cutter_finding::kFlutesTooShort, *flutes);
    const double stickOut = cutter.body().stickOut;
    if (stickOut > 0 && stickOut < cutter.profileHeight())
        return refuse(cutter_finding::kStickOutTooShort, stickOut);
    return {};
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

    std::vector<double> own(values->own);
    for (std::size_t i = 0; i < own.size(); ++i)
        own[i] = values->value(i);
    auto profile = shape->profile({own, values->ownText()});
    if (!profile)
        return tl::unexpected(std::move(profile.error()));
    auto body = readBody(*values, *profile);
    if (!body)
        return tl::unexpected(std::move(body.error()));
    const auto data = readData(*values);
    if (!data)
        return tl::unexpected(data.error());
    Cutter cutter(std::string(trimmed(spec)), std::move(*profile), std::move(*body), *data);
    if (auto checked = checkLengths(*values, cutter); !checked)
        return tl::unexpected(std::move(checked.error()));
    return cutter;
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
