// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/diagnostic.h"
#include "core/cutter/cutter.h"

namespace proveout {

/// The cutters by tool number. Value type.
class ToolTable {
public:
    void set(int number, Cutter cutter) { m_tools.insert_or_assign(number, std::move(cutter)); }
    void remove(int number) { m_tools.erase(number); }
    /// nullptr where the number is not in the table; valid until the table changes.
    [[nodiscard]] const Cutter* find(int number) const {
        const auto found = m_tools.find(number);
        return found == m_tools.end() ? nullptr : &found->second;
    }
    [[nodiscard]] const std::map<int, Cutter>& tools() const { return m_tools; }

    friend bool operator==(const ToolTable&, const ToolTable&) = default;

private:
    std::map<int, Cutter> m_tools;
};

/// Reads `N=SHAPE:key=value,…` (also `TN=…`) of the command line into a number and a cutter.
[[nodiscard]] Result<std::pair<int, Cutter>> parseToolOption(std::string_view option);

} // namespace proveout
