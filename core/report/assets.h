// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace proveout {

/// Files of the page, as they are in the program. Live as long as it.
[[nodiscard]] std::string_view reportStyle();
/// The scripts of the view in 3D, in their order; empty if the program was built without three.js.
[[nodiscard]] std::string_view threeScript();
[[nodiscard]] std::string_view orbitScript();
[[nodiscard]] std::string_view loaderScript();
[[nodiscard]] std::string_view viewerScript();

} // namespace proveout
