// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/cutter/cutter.h"

namespace proveout {

/// Where the sizes of a tool come from.
enum class ToolSource : std::uint8_t {
    given,   ///< stated by the user, a job or a tool table
    comment, ///< stated by a comment of the program; the user has not confirmed them
    assumed, ///< default sizes, so that the moves of the tool can be simulated
};

/// "given", "comment" or "assumed", as in files and JSON.
[[nodiscard]] const char* name(ToolSource source);

/// Where the sizes of one tool come from. Value type.
struct ToolOrigin {
    ToolSource source = ToolSource::given;
    std::uint32_t line = 0;   ///< of the comment, 1-based; 0 if there is none
    std::string comment = {}; ///< its text
    /// Values that the comment does not state and that are defaults: keys of the cutter's spec, or "shape".
    std::vector<std::string> defaults = {};
    /// What the user has entered since, without confirming the tool: keys as of `defaults`.
    std::vector<std::string> entered = {};

    /// Whether a size, given by its key in the cutter's spec, was stated by the comment or the user.
    [[nodiscard]] bool states(const std::string& key) const;

    friend bool operator==(const ToolOrigin&, const ToolOrigin&) = default;
};

/// The cutters by tool number, and which of them are not confirmed. Value type.
class ToolTable {
public:
    void set(int number, Cutter cutter, ToolOrigin origin = {});
    void remove(int number);
    /// Marks the sizes of a tool as right: from now on they are given. Does nothing if the table has no such
    /// tool.
    void confirm(int number) { m_unconfirmed.erase(number); }
    void confirmAll() { m_unconfirmed.clear(); }

    /// nullptr where the number is not in the table; valid until the table changes.
    [[nodiscard]] const Cutter* find(int number) const {
        const auto found = m_tools.find(number);
        return found == m_tools.end() ? nullptr : &found->second;
    }
    [[nodiscard]] const std::map<int, Cutter>& tools() const { return m_tools; }
    /// The origins of the sizes of those tools whose sizes are not given.
    [[nodiscard]] const std::map<int, ToolOrigin>& unconfirmed() const { return m_unconfirmed; }
    /// nullptr where the sizes are given, or the number is not in the table; valid until the table changes.
    [[nodiscard]] const ToolOrigin* unconfirmedOrigin(int number) const {
        const auto found = m_unconfirmed.find(number);
        return found == m_unconfirmed.end() ? nullptr : &found->second;
    }

    friend bool operator==(const ToolTable&, const ToolTable&) = default;

private:
    std::map<int, Cutter> m_tools;
    std::map<int, ToolOrigin> m_unconfirmed; ///< its numbers are also in m_tools
};

/// Reads `N=SHAPE:key=value,…` (also `TN=…`) of the command line into a number and a cutter.
[[nodiscard]] Result<std::pair<int, Cutter>> parseToolOption(std::string_view option);

} // namespace proveout
