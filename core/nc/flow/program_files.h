// SPDX-License-Identifier: GPL-3.0-or-later
// The files of subprograms beside the program that calls them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace proveout {

/// The usual file names, on controls and by hand, of a program of custom macro B's dialect: by number, or by
/// name if it is not empty. In the order in which they are searched for.
[[nodiscard]] std::vector<std::string> macroFileNames(int number, std::string_view name);

/// The file of an O-word subprogram of LinuxCNC; empty if its label cannot be the name of a file in a folder.
[[nodiscard]] std::string subFileName(std::string_view label);

} // namespace proveout
