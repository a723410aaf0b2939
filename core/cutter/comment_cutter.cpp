// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a cutter from what comments state about it.
#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <iterator>
#include <span>
#include <string>
#include <string_view>

#include "core/cutter/tool_comment.h"

namespace proveout {

namespace {

/// Where the value of a key comes from.
enum class ValueOf : std::uint8_t {
    cornerRadius,
    includedAngle, ///< otherwise twice the side angle, if stated
    pointAngle,    ///< of drills, whose point CAM systems list as the taper
    sideAngle,     ///< otherwise half the included angle, if stated
    tipDiameter,
    nothing, ///< no comment states it
};

/// A key of a shape other than its diameter, and its value where the comment does not state it: `constant`
/// plus `perDiameter` times the diameter.
struct KeyRow {
    std::string_view shape;
    const char* key;
    ValueOf value;
    double constant;
    double perDiameter;
    bool optional = false; ///< omitted from the spec where it is not stated
};

constexpr KeyRow kStatedKeys[] = {
    {"bull", "r", ValueOf::cornerRadius, 0, 0.1},      {"cone", "angle", ValueOf::includedAngle, 60, 0},
    {"cone", "tip", ValueOf::tipDiameter, 0, 0, true}, {"drill", "angle", ValueOf::pointAngle, 118, 0},
    {"taper", "angle", ValueOf::sideAngle, 3, 0},      {"taper", "h", ValueOf::nothing, 0, 4},
    {"taper", "r", ValueOf::cornerRadius, 0, 0, true}, {"taperball", "angle", ValueOf::sideAngle, 3, 0},
    {"taperball", "h", ValueOf::nothing, 0, 4},        {"chamfer", "angle", ValueOf::includedAngle, 90, 0},
    {"chamfer", "tip", ValueOf::tipDiameter, 0, 0},    {"face", "angle", ValueOf::sideAngle, 90, 0},
    {"face", "h", ValueOf::nothing, 0, 0.1},           {"face", "r", ValueOf::cornerRadius, 0, 0, true},
    {"spot", "angle", ValueOf::pointAngle, 90, 0},     {"centre", "pilot", ValueOf::tipDiameter, 0, 0.4},
    {"centre", "pl", ValueOf::nothing, 0, 0.5},        {"tap", "tip", ValueOf::tipDiameter, 0, 0.7},
    {"tap", "lead", ValueOf::nothing, 0, 0.6},         {"lollipop", "neck", ValueOf::nothing, 0, 0.6},
    {"tslot", "w", ValueOf::nothing, 0, 0.3},          {"tslot", "neck", ValueOf::nothing, 0, 0.45},
    {"dovetail", "angle", ValueOf::sideAngle, 60, 0},  {"dovetail", "h", ValueOf::nothing, 0, 0.3},
};

std::optional<double> stated(ValueOf value, const ToolComment& tool) {
    const auto either = [](const std::optional<double>& first, const std::optional<double>& second,
                           double factor) -> std::optional<double> {
        if (first && *first > 0)
            return first;
        return second && *second > 0 ? std::optional(*second * factor) : std::nullopt;
    };
    switch (value) {
    case ValueOf::cornerRadius:
        return tool.cornerRadius;
    case ValueOf::includedAngle:
        return either(tool.includedAngle, tool.sideAngle, 2);
    case ValueOf::pointAngle:
        return either(tool.includedAngle, tool.sideAngle, 1);
    case ValueOf::sideAngle:
        return either(tool.sideAngle, tool.includedAngle, 0.5);
    case ValueOf::tipDiameter:
        return tool.tipDiameter;
    case ValueOf::nothing:
        break;
    }
    return {};
}

/// The shape by its name and by its sizes: a corner radius makes an end mill a bull-nose or a ball-end mill.
std::string_view shapeOf(const ToolComment& tool) {
    constexpr double kRoundsAll = 0.499; ///< corner radius divided by diameter: no flat part of the tip
                                         ///< remains
    const std::string_view named = tool.shape;
    const double corner = tool.cornerRadius.value_or(0);
    const double taper = tool.sideAngle.value_or(0);
    const bool endMill = named.empty() || named == "flat" || named == "bull";
    if (endMill && corner >= kRoundsAll * *tool.diameter)
        return taper > 0 ? "taperball" : "ball";
    if (endMill && taper > 0)
        return "taper";
    if (endMill && corner > 0)
        return "bull";
    if (named == "ball" && taper > 0)
        return "taperball";
    return named.empty() ? "flat" : named;
}

/// Whether the comment states the shape, or it is only assumed.
bool isShapeStated(const ToolComment& tool) {
    return *tool.shape != '\0' || tool.cornerRadius || tool.sideAngle;
}

} // namespace

Result<CommentCutter> makeCutter(const ToolComment& tool) {
    const std::string_view shape = shapeOf(tool);
    std::vector<std::string> defaults;
    if (!isShapeStated(tool))
        defaults.emplace_back("shape");
    std::string spec = fmt::format("{}:d={:.6g}", shape, *tool.diameter);
    for (const KeyRow& row : kStatedKeys) {
        if (row.shape != shape)
            continue;
        const auto value = stated(row.value, tool);
        if (!value && row.optional)
            continue;
        if (!value)
            defaults.emplace_back(row.key);
        spec += fmt::format(",{}={:.6g}", row.key,
                            value.value_or(row.constant + row.perDiameter * *tool.diameter));
    }
    if (tool.fluteLength)
        spec += fmt::format(",l={:.6g}", *tool.fluteLength);
    else
        defaults.emplace_back("l");
    auto cutter = parseCutter(spec);
    if (!cutter)
        return tl::unexpected(std::move(cutter.error()));
    return CommentCutter{std::move(*cutter), std::move(defaults)};
}

} // namespace proveout
