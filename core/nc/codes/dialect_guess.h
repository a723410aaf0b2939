// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/nc/text/dialect.h"
#include "core/nc/text/nc_text.h"

namespace proveout {

/// An indication of a dialect in a text.
struct DialectSign {
    DialectId dialect = DialectId::linuxcnc;
    int weight = 0;
    int line = 0;      ///< 1-based, of the first occurrence
    std::string shown; ///< as written there

    bool operator==(const DialectSign&) const = default;
};

struct DialectGuess {
    DialectId dialect = DialectId::linuxcnc;
    std::vector<DialectSign> reasons; ///< the signs for it, by line; empty: the text does not indicate a
                                      ///< dialect

    bool operator==(const DialectGuess&) const = default;
};

/// For which control a text was written, judging by codes that only some controls accept, and by the post
/// processor or the control that a comment of its heading names. Reads at most its first hundred thousand
/// lines. Pure; any thread.
[[nodiscard]] DialectGuess guessDialect(const NcText& text);

} // namespace proveout
