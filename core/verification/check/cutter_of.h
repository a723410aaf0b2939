// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace proveout {

/// What a finding depends on of a tool with this spec, in one spelling, as the spec of a cutter: without the
/// limits of its use, which the finding itself names, and without stick-out and holder where the finding,
/// given by its id, is about the cutting edges alone.
[[nodiscard]] std::string cutterOf(std::string_view spec, std::string_view finding);

} // namespace proveout
