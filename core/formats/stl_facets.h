// SPDX-License-Identifier: GPL-3.0-or-later
// The facets of either encoding of STL before vertices are joined.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/base/diagnostic.h"

namespace proveout {

/// A facet as in the file: its normal and its three corners.
using StlFacet = std::array<std::array<float, 3>, 4>;

struct StlFacets {
    std::vector<StlFacet> facets;
    Diagnostics warnings;
};

/// Reads the text of an ASCII STL, including several solids in a row. Case of keywords is ignored, white
/// space is that of StlWords. Errors have line and column; a missing `endsolid` is a warning. Linear in the
/// text.
[[nodiscard]] Result<StlFacets> readAsciiFacets(std::string_view text);

} // namespace proveout
