// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/cutter/shapes.h"

namespace proveout {

/// `SHAPE:key=value,…` taken apart for a form. Value type.
struct ToolSpec {
    std::string shape;
    std::map<std::string, double> values;
    std::map<std::string, std::string> texts; ///< of keys whose values are text
};

/// Reads the spec of a cutter; keys that are no shape's are dropped.
[[nodiscard]] ToolSpec readSpec(std::string_view spec);

/// Writes a spec; keys that have their standard value and need not be told are left out.
[[nodiscard]] std::string writeSpec(const ToolSpec& spec);

/// The keys of a shape, then those of every shape.
[[nodiscard]] std::vector<ShapeKey> keysOf(std::string_view shape);

/// The row of a shape; the first row where the name is unknown.
[[nodiscard]] const CutterShape& shapeRow(std::string_view shape);

/// The tool that a dialog proposes: the first shape with its standard values.
[[nodiscard]] ToolSpec defaultSpec();

} // namespace proveout
