// SPDX-License-Identifier: GPL-3.0-or-later
// What several panels show and do about tools that are missing from the table or not confirmed. Thread: UI.
#pragma once

#include <vector>

#include <QLocale>
#include <QString>

#include "core/simulation/setup/tool_choice.h"

namespace proveout {

class Session;

/// Which tools the program lacks, and which of those it uses are not confirmed; none without a program.
[[nodiscard]] ToolChoice toolChoice(const Session& session);

/// The numbers of the tools that the program lacks, in the order in which it misses them.
[[nodiscard]] std::vector<int> missingTools(const Session& session);

/// Adds the tools that the program lacks with default sizes, which are marked as assumed.
void assumeMissingTools(Session& session);

/// The sizes of all tools in the table are right.
void confirmTools(Session& session);

/// "T1, T2, T3", the first few of them.
[[nodiscard]] QString toolList(const std::vector<int>& numbers);

/// "%1 (assumed)", of a tool.
[[nodiscard]] QString assumedText(const QString& tool);

/// "T3", "T3 (assumed)": the tool of a motion that names tool `number`; "no tool" where it has none.
[[nodiscard]] QString toolText(int number, const ToolChoice& choice, const ToolTable& tools);

/// "⌀ 6 mm Flat end mill": the size first, because a narrow column cuts off what follows.
[[nodiscard]] QString cutterText(const Cutter& cutter, const QLocale& locale);

} // namespace proveout
