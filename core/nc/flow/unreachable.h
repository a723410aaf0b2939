// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include "core/nc/text/dialect.h"
#include "core/nc/text/nc_text.h"

namespace proveout {

/// Lines of a text that cannot be reached, because the line before them always jumps elsewhere. Lines after
/// M2 and M30 are not included: they are reported where the program ends.
class Unreachable {
public:
    /// A line, 0-based, was executed and always jumps elsewhere: GOTO, M99, return.
    void leaves(std::size_t line) { m_leaving.insert(line); }

    /// The first line of each unreachable part, with the line that always jumps past it. Linear in the text
    /// if there are any.
    [[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> find(const NcText& text,
                                                                        MacroLanguage macros) const;

private:
    std::set<std::size_t> m_leaving;
};

} // namespace proveout
