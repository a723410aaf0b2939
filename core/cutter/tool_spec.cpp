// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutter/tool_spec.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

namespace proveout {

const CutterShape& shapeRow(std::string_view shape) {
    const auto shapes = cutterShapes();
    const auto found =
        std::find_if(shapes.begin(), shapes.end(), [&](const CutterShape& s) { return shape == s.key; });
    return found == shapes.end() ? shapes.front() : *found;
}

std::vector<ShapeKey> keysOf(std::string_view shape) {
    return keysOf(shapeRow(shape));
}

namespace {

std::string_view withoutSpaces(std::string_view text) {
    const std::size_t first = std::min(text.find_first_not_of(" \t"), text.size());
    return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

/// Adopts the value if the tool has this key.
void readPair(std::string_view pair, ToolSpec& tool) {
    const std::size_t equals = pair.find('=');
    if (equals == std::string_view::npos)
        return;
    const std::string key(withoutSpaces(pair.substr(0, equals)));
    const std::string_view given = withoutSpaces(pair.substr(equals + 1));
    if (const auto text = tool.texts.find(key); text != tool.texts.end())
        text->second = given;
    double value = 0;
    const auto place = tool.values.find(key);
    if (place != tool.values.end() &&
        std::from_chars(given.data(), given.data() + given.size(), value).ec == std::errc())
        place->second = value;
}

/// The value of a key as written in a spec; empty if it can be omitted.
std::string valueToReport(const ToolSpec& spec, const ShapeKey& key) {
    if (key.isText())
        return spec.texts.at(key.key);
    const double value = spec.values.at(key.key);
    return key.required || value != key.defaultValue ? fmt::format("{}", value) : std::string();
}

} // namespace

ToolSpec readSpec(std::string_view spec) {
    ToolSpec tool;
    const std::size_t colon = std::min(spec.find(':'), spec.size());
    tool.shape = withoutSpaces(spec.substr(0, colon));
    for (const ShapeKey& key : keysOf(tool.shape)) {
        if (key.isText())
            tool.texts[key.key] = key.defaultText;
        else
            tool.values[key.key] = key.defaultValue;
    }
    spec.remove_prefix(std::min(colon + 1, spec.size()));
    while (!spec.empty()) {
        const std::string_view pair = spec.substr(0, spec.find(','));
        readPair(pair, tool);
        spec.remove_prefix(std::min(pair.size() + 1, spec.size()));
    }
    return tool;
}

std::string writeSpec(const ToolSpec& spec) {
    std::string text;
    for (const ShapeKey& key : keysOf(spec.shape)) {
        const std::string value = valueToReport(spec, key);
        if (key.required || !value.empty())
            text += fmt::format("{}{}={}", text.empty() ? ':' : ',', key.key, value);
    }
    return spec.shape + text;
}

ToolSpec defaultSpec() {
    return readSpec(cutterShapes().front().key);
}

} // namespace proveout
