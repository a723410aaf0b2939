// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the codes, by who understands them. codes.cpp puts the tables of the dialects together.
#pragma once

#include <initializer_list>
#include <span>
#include <vector>

#include "core/nc/codes/codes.h"

namespace proveout {

[[nodiscard]] std::span<const CodeRow> basicCodes();     ///< alike on every control
[[nodiscard]] std::span<const CodeRow> foreignCodes();   ///< known, of controls that are none of ours
[[nodiscard]] std::span<const CodeRow> rs274Codes();     ///< of LinuxCNC
[[nodiscard]] std::span<const CodeRow> fanucCodes();     ///< of Fanuc, and of Haas as far as it is the same
[[nodiscard]] std::span<const CodeRow> haasCodes();      ///< of Haas, over those of Fanuc
[[nodiscard]] std::span<const CodeRow> fanucFunctions(); ///< of machines with Fanuc's control, as is usual
[[nodiscard]] std::span<const CodeRow> haasFunctions();  ///< of Haas' machines
[[nodiscard]] std::span<const CodeRow> grblCodes();      ///< of grbl, all of them
[[nodiscard]] std::span<const CodeRow> machCodes();      ///< of Mach, over the basic ones

/// The rows of `all` that other controls of the family have just so, by their tenths.
[[nodiscard]] std::vector<CodeRow> sameRows(std::span<const CodeRow> all, char letter,
                                            std::initializer_list<int> tenths);

} // namespace proveout
