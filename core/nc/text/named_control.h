// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "core/nc/text/dialect.h"

namespace proveout {

/// The control that a text was written for according to a comment.
struct NamedControl {
    DialectId dialect = DialectId::linuxcnc;
    bool named = false; ///< if false, the comment is only typical of the posts for this control
};

/// What the first comment of a line says about it: by a name beside "post", after "machine", or alone with
/// its model; nothing if it says nothing, or only mentions a control.
[[nodiscard]] std::optional<NamedControl> namedControl(std::string_view line);

} // namespace proveout
