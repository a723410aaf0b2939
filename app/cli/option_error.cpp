// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/option_error.h"

#include <utility>

namespace proveout::cli {

tl::unexpected<Diagnostics> aboutOption(const char* option, Diagnostics diagnostics) {
    for (Diagnostic& diagnostic : diagnostics) {
        diagnostic.arguments = {option, message(diagnostic)};
        diagnostic.text = "{}: {}";
        diagnostic.file = "proveout-cli";
    }
    return tl::unexpected(std::move(diagnostics));
}

} // namespace proveout::cli
