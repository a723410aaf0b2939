// SPDX-License-Identifier: GPL-3.0-or-later
// The names of unfinished files, and the removal of those whose writer was killed.
#pragma once

#include <filesystem>
#include <string>

namespace proveout {

/// A different name each time, `.proveout-HHHHHHHHNNNNNNNN.part`: H distinguishes the computers that write
/// into a shared folder. Its length does not depend on that of the target's name, which may have the full 255
/// bytes already.
[[nodiscard]] std::string unfinishedName();

/// Marks an open file as being written by this process, until all its descriptors are closed, however the
/// process ends. False if another process has claimed it already or has removed its name.
[[nodiscard]] bool claimUnfinished(int descriptor);

/// Removes the unfinished files in a folder that this user's processes have written on this computer and that
/// no longer have a running process. A file that any process is still writing stays. A file that cannot be
/// removed stays too.
void removeUnfinished(const std::filesystem::path& folder);

} // namespace proveout
