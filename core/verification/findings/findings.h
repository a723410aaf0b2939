// SPDX-License-Identifier: GPL-3.0-or-later
// The one table of all findings, whichever part reports them. The rows of the core are in the libraries that
// report them, those of the window and of the command line beside this file, because the core includes
// neither ui nor app. A new table is one line of findings.cpp.
#pragma once

#include <span>
#include <string_view>

#include "core/base/finding_row.h"

namespace proveout {

/// All rows, in the order of the core libraries. Lives as long as the program; any thread.
[[nodiscard]] std::span<const FindingTable> findingTables();

/// The first row of an id; null where there is none. Rows with one id have one title.
[[nodiscard]] const FindingRow* findFinding(std::string_view id);

/// The short name of a finding, in English; empty where the id is unknown.
[[nodiscard]] const char* findingTitle(std::string_view id);

} // namespace proveout
