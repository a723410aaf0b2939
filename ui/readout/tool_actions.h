// SPDX-License-Identifier: GPL-3.0-or-later
// What several panels show and do about tools that are missing from the table or unconfirmed. Thread: UI.
#pragma once

#include <vector>

#include <QLocale>
#include <QString>

#include "core/simulation/setup/tool_choice.h"

namespace proveout {

class Session;

/// Which tools the program lacks, and which of those it uses are unconfirmed; empty without a program.
[[nodiscard]] ToolChoice toolChoice(const Session& session);

/// The numbers of the missing tools, by first use in the program.
[[nodiscard]] std::vector<int> missingTools(const Session& session);

/// Adds the missing tools with default sizes, marked as assumed.
void assumeMissingTools(Session& session);

/// Marks the sizes of all tools in the table as confirmed.
void confirmTools(Session& session);

/// "T1, T2, T3": the first few of the numbers.
[[nodiscard]] QString toolList(const std::vector<int>& numbers);

/// "%1 (assumed)" for a tool.
[[nodiscard]] QString assumedText(const QString& tool);

/// "T3" or "T3 (assumed)": the tool of a motion that names tool `number`; "no tool" if it has none.
[[nodiscard]] QString toolText(int number, const ToolChoice& choice, const ToolTable& tools);

/// "⌀ 6 mm Flat end mill": the size comes first, because a narrow column cuts off the end.
[[nodiscard]] QString cutterText(const Cutter& cutter, const QLocale& locale);

} // namespace proveout
