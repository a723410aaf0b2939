// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/diagnostic.h"

namespace proveout::cli {

/// Adds the name of the option to messages about its value, which otherwise would look like messages about
/// the program.
[[nodiscard]] tl::unexpected<Diagnostics> aboutOption(const char* option, Diagnostics diagnostics);

} // namespace proveout::cli
