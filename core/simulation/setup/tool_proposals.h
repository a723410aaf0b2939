// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>

#include "core/cutter/tool_table.h"
#include "core/nc/text/nc_text.h"

namespace proveout {

/// The tools that the comments of a program describe. Value type.
struct ToolProposals {
    /// Each with the comment that it was read from. A tool without a number gets the next free one.
    ToolTable tools;
    /// The numbers that the program calls with T.
    std::set<int> called;
    bool callsComputed = false; ///< it also calls tools by parameters and expressions

    friend bool operator==(const ToolProposals&, const ToolProposals&) = default;
};

/// Reads the comments of a program: lists of tools in its header, and comments at its tool changes. A comment
/// without a tool number belongs to the tool that was just called, otherwise to the one called next before
/// any motion. Lengths without a unit are in the unit of the program at that place. Pure, any thread; reads
/// at most the first million lines and hundred thousand comments.
[[nodiscard]] ToolProposals proposeTools(const NcText& text);

/// Adds missing tools to `tools`: the proposals that the program calls; if it calls none and the table is
/// empty, all. A tool that was proposed `before`, and is no longer in the table, has been removed and is not
/// added again. Proposals that are in the table and unconfirmed are updated from their comment, except for
/// entered values.
void addProposals(ToolTable& tools, const ToolProposals& proposals, const ToolProposals& before = {});

} // namespace proveout
