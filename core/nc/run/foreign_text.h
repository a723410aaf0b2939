// SPDX-License-Identifier: GPL-3.0-or-later
// Texts that no supported dialect reads: programs of other controls, and files that are not programs.
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
    std::string sign;                    ///< the sign that identifies it, as written in the text
    int line = 1;                        ///< 1-based, of the sign
};

/// The kind of a text that no control of dialects() could read; nothing if it may be a program of theirs.
/// Reads the first two thousand lines, for a lathe program a hundred thousand. Pure; any thread.
[[nodiscard]] std::optional<ForeignText> findForeignText(const NcText& text);

/// The program for such a text: one message and nothing else. Null if the options name a dialect, or if the
/// text may be a supported program.
[[nodiscard]] std::shared_ptr<const Program> foreignProgram(const NcText& text,
                                                            const InterpretOptions& options);

} // namespace proveout
