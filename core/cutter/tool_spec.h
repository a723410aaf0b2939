// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/cutter/shapes.h"

namespace proveout {

/// `SHAPE:key=value,…` split into its parts for a form. Value type.
struct ToolSpec {
    std::string shape;
    std::map<std::string, double> values;
    std::map<std::string, std::string> texts; ///< for keys whose values are text
};

/// Reads the spec of a cutter; keys that the shape does not have are dropped.
[[nodiscard]] ToolSpec readSpec(std::string_view spec);

/// Writes a spec; optional keys with their default value are omitted.
[[nodiscard]] std::string writeSpec(const ToolSpec& spec);

/// The keys of a shape, followed by those that all shapes have.
[[nodiscard]] std::vector<ShapeKey> keysOf(std::string_view shape);

/// The row of a shape; the first row if the name is unknown.
[[nodiscard]] const CutterShape& shapeRow(std::string_view shape);

/// The tool that a dialog proposes: the first shape with its default values.
[[nodiscard]] ToolSpec defaultSpec();

} // namespace proveout
