// SPDX-License-Identifier: GPL-3.0-or-later
// The sections of a program, for lists in an editor.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/nc/text/dialect.h"
#include "core/nc/text/nc_text.h"

namespace proveout {

enum class SectionKind : std::uint8_t {
    program,    ///< O1000
    subprogram, ///< o<probe> sub
    tool,       ///< from a tool change to the next one
    operation,  ///< a comment on a line of its own, and the blocks after it
    label,      ///< a block number to which a line jumps
};

/// Lines and indices are 0-based.
struct Section {
    SectionKind kind = SectionKind::operation;
    std::size_t depth = 0;    ///< number of the sections that contain it
    std::string name;         ///< "O1000", "probe", "T5", "N100", or the comment
    std::string comment;      ///< beside the name; may be empty
    int tool = -1;            ///< of a tool change; -1: its number is computed
    std::size_t line = 0;     ///< the first one
    std::size_t lastLine = 0; ///< within it
    std::size_t begin = 0;    ///< what names it, in its first line
    std::size_t end = 0;
};

constexpr std::size_t kMostSections = 20'000;

/// The sections in the order of the text, those within others after them; at most the first kMostSections.
/// Comments before the first block of a program are its heading and no operations. Without an M6 every T word
/// begins a tool. Time is linear in the text; pure, any thread.
[[nodiscard]] std::vector<Section> outlineOf(const NcText& text, DialectId dialect);

} // namespace proveout
