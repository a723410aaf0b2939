// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the codes, by the dialects that support them. codes.cpp combines the tables of the dialects.
#pragma once

#include <initializer_list>
#include <span>
#include <vector>

#include "core/nc/codes/codes.h"

namespace proveout {

[[nodiscard]] std::span<const CodeRow> basicCodes();     ///< the same on every control
[[nodiscard]] std::span<const CodeRow> foreignCodes();   ///< known codes of controls that are not supported
[[nodiscard]] std::span<const CodeRow> rs274Codes();     ///< of LinuxCNC
[[nodiscard]] std::span<const CodeRow> fanucCodes();     ///< of Fanuc, and of Haas where it is the same
[[nodiscard]] std::span<const CodeRow> haasCodes();      ///< of Haas, overriding those of Fanuc
[[nodiscard]] std::span<const CodeRow> fanucFunctions(); ///< of usual machines with Fanuc's control
[[nodiscard]] std::span<const CodeRow> haasFunctions();  ///< of Haas's machines
[[nodiscard]] std::span<const CodeRow> grblCodes();      ///< all codes of grbl
[[nodiscard]] std::span<const CodeRow> machCodes();      ///< of Mach, overriding the basic ones

/// The rows of `all`, by their tenths, that other controls of the family have unchanged.
[[nodiscard]] std::vector<CodeRow> sameRows(std::span<const CodeRow> all, char letter,
                                            std::initializer_list<int> tenths);

} // namespace proveout
