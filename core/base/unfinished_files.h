// SPDX-License-Identifier: GPL-3.0-or-later
// The names of files that are not written yet, and what is left of them where their writer was killed.
#pragma once

#include <filesystem>
#include <string>

namespace proveout {

/// Another name each time, `.proveout-HHHHHHHHNNNNNNNN.part`: H tells the computers apart that write into a
/// shared folder. Its length does not depend on that of the file: a file may have the full 255 bytes already.
[[nodiscard]] std::string unfinishedName();

/// Marks an open file as being written by this process, until all its descriptors are closed, however the
/// process ends. False where another process has it already or has removed its name.
[[nodiscard]] bool claimUnfinished(int descriptor);

/// Removes the unfinished files in a folder that this user has written on this computer by processes that no
/// longer exist. What is being written, by whichever process, stays. A file that cannot be removed stays too.
void removeUnfinished(const std::filesystem::path& folder);

} // namespace proveout
