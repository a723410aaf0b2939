// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace proveout {

/// `proveout study …`: the command of proveout-cli with a renderer for measuring and a painter for PNG. Needs
/// a QGuiApplication. Returns the exit code.
[[nodiscard]] int studyMain(int argc, char** argv);

} // namespace proveout
