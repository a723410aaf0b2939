// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <set>
#include <utility>
#include <vector>

#include "core/nc/text/dialect.h"
#include "core/nc/text/nc_text.h"

namespace proveout {

/// Lines of a text to which nothing leads, because the line before them always goes elsewhere. What M2 and
/// M30 leave behind is not among them: that is told where the program ends.
class Unreachable {
public:
    /// A line, 0-based, was carried out and always leads elsewhere: GOTO, M99, return.
    void leaves(std::size_t line) { m_leaving.insert(line); }

    /// The first line behind each of those that nothing leads to, with the one that leaves. Linear in the
    /// text where there are any.
    [[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> find(const NcText& text,
                                                                        MacroLanguage macros) const;

private:
    std::set<std::size_t> m_leaving;
};

} // namespace proveout
