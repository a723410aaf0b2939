// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the codes, by who understands them. codes.cpp puts the tables of the dialects together.
#pragma once

#include <span>

#include "core/nc/codes.h"

namespace proveout {

[[nodiscard]] std::span<const CodeRow> basicCodes();   ///< alike on every control
[[nodiscard]] std::span<const CodeRow> foreignCodes(); ///< known, of controls that are none of ours
[[nodiscard]] std::span<const CodeRow> rs274Codes();   ///< of LinuxCNC
[[nodiscard]] std::span<const CodeRow> fanucCodes();   ///< of Fanuc, and of Haas as far as it is the same
[[nodiscard]] std::span<const CodeRow> haasCodes();    ///< of Haas, over those of Fanuc

} // namespace proveout
