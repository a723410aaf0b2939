// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/zmap/extruded_stock.h"

namespace proveout {

/// Reads closed loops of lines and arcs. Each line of the text is a point, `X Y` or `X Y BULGE`
/// (OutlinePoint), separated by blanks, tabs, commas or semicolons; an empty line begins another loop; text
/// after `#` is a comment. Errors, with the line: anything that is not two or three finite numbers, a loop of
/// less than two points, a file larger than any outline, no points.
[[nodiscard]] Result<std::vector<OutlineLoop>> readOutline(const std::filesystem::path& file);

} // namespace proveout
