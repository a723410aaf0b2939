// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/diagnostic.h"

namespace proveout::cli {

/// Makes messages that are about the value of an option name it, where they would else be taken for messages
/// about the program.
[[nodiscard]] tl::unexpected<Diagnostics> aboutOption(const char* option, Diagnostics diagnostics);

} // namespace proveout::cli
