// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/setup/tool_spec.h"

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
    const CutterShape& row = shapeRow(shape);
    std::vector<ShapeKey> keys(row.keys.begin(), row.keys.end());
    const auto common = commonShapeKeys();
    keys.insert(keys.end(), common.begin(), common.end());
    return keys;
}

ToolSpec readSpec(std::string_view spec) {
    ToolSpec tool;
    const std::size_t colon = std::min(spec.find(':'), spec.size());
    tool.shape = spec.substr(0, colon);
    for (const ShapeKey& key : keysOf(tool.shape))
        tool.values[key.key] = key.standard;
    spec.remove_prefix(std::min(colon + 1, spec.size()));
    while (!spec.empty()) {
        const std::string_view pair = spec.substr(0, spec.find(','));
        const std::size_t equals = pair.find('=');
        double value = 0;
        if (equals != std::string_view::npos &&
            std::from_chars(pair.data() + equals + 1, pair.data() + pair.size(), value).ec == std::errc()) {
            const auto place = tool.values.find(std::string(pair.substr(0, equals)));
            if (place != tool.values.end())
                place->second = value;
        }
        spec.remove_prefix(std::min(pair.size() + 1, spec.size()));
    }
    return tool;
}

std::string writeSpec(const ToolSpec& spec) {
    std::string text;
    for (const ShapeKey& key : keysOf(spec.shape)) {
        const auto value = spec.values.find(key.key);
        if (value != spec.values.end() && (key.required || value->second != key.standard))
            text += fmt::format("{}{}={}", text.empty() ? ':' : ',', key.key, value->second);
    }
    return spec.shape + text;
}

ToolSpec standardSpec() {
    return readSpec(cutterShapes().front().key);
}

} // namespace proveout
