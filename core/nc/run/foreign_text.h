// SPDX-License-Identifier: GPL-3.0-or-later
// Texts that no dialect of ours reads: programs of other controls, and files that are no programs.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/nc/program/program.h"
#include "core/nc/run/interpreter.h"
#include "core/nc/text/messages.h"
#include "core/nc/text/nc_text.h"

namespace proveout {

struct ForeignText {
    const char* kind = "";               ///< "a Heidenhain conversational program", marked with PROVEOUT_TEXT
    const FindingRow* message = nullptr; ///< its arguments: kind, line, sign and dialects
    std::string sign;                    ///< what shows it, as the text has it
    int line = 1;                        ///< 1-based, where that is
};

/// What a text is, by what no control of dialects() could read; nothing where it may be a program of theirs.
/// Looks at the first two thousand lines, for a lathe's program at a hundred thousand. Pure; any thread.
[[nodiscard]] std::optional<ForeignText> findForeignText(const NcText& text);

/// The program of such a text: one message and nothing else. Null where the options name a dialect, or the
/// text may be a program of ours.
[[nodiscard]] std::shared_ptr<const Program> foreignProgram(const NcText& text,
                                                            const InterpretOptions& options);

} // namespace proveout
