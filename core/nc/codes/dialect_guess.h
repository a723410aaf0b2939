// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/nc/text/dialect.h"
#include "core/nc/text/nc_text.h"

namespace proveout {

/// What in a text speaks for a dialect.
struct DialectSign {
    DialectId dialect = DialectId::linuxcnc;
    int weight = 0;
    int line = 0;      ///< 1-based, where it stands first
    std::string shown; ///< as it stands there

    bool operator==(const DialectSign&) const = default;
};

struct DialectGuess {
    DialectId dialect = DialectId::linuxcnc;
    std::vector<DialectSign> reasons; ///< those for it, by line; none: nothing in the text tells

    bool operator==(const DialectGuess&) const = default;
};

/// For which control a text was written, by what only some of them understand, and by the post processor or
/// the control that a comment of its heading names. Reads at most its first hundred thousand lines. Pure; any
/// thread.
[[nodiscard]] DialectGuess guessDialect(const NcText& text);

} // namespace proveout
