// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>

#include "core/cutter/tool_table.h"
#include "core/nc/text/nc_text.h"

namespace proveout {

/// The tools that the comments of a program describe. Value type.
struct ToolProposals {
    /// Each with the comment that it was read from. A tool without a number has the next free one.
    ToolTable tools;
    /// The numbers that the program calls with T.
    std::set<int> called;
    bool callsComputed = false; ///< it also calls tools by parameters and expressions

    friend bool operator==(const ToolProposals&, const ToolProposals&) = default;
};

/// Reads the comments of a program: lists of tools in its header, and comments at its tool changes. A comment
/// without a tool number belongs to the tool that was just called, else to the one called next before any
/// motion. Lengths without a unit are in the unit of the program there. Pure, any thread; reads at most the
/// first million lines and hundred thousand comments.
[[nodiscard]] ToolProposals proposeTools(const NcText& text);

/// Adds to `tools` what it has not: of the proposals, those that the program calls; where it calls none and
/// the table is empty, all. What was offered `before`, and is no longer in the table, was removed and stays
/// away. Proposals that are in the table and unconfirmed follow their comment, but for what was entered.
void addProposals(ToolTable& tools, const ToolProposals& proposals, const ToolProposals& before = {});

} // namespace proveout
