// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "core/nc/text/dialect.h"

namespace proveout {

/// The control that a comment says the text was written for.
struct NamedControl {
    DialectId dialect = DialectId::linuxcnc;
    bool named = false; ///< otherwise the comment is only such as the posts for this control write
};

/// What the first comment of a line says of it: by a name beside "post", behind "machine", or alone with its
/// model; nothing where it says nothing, or only mentions a control.
[[nodiscard]] std::optional<NamedControl> namedControl(std::string_view line);

} // namespace proveout
