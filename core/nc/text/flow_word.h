// SPDX-License-Identifier: GPL-3.0-or-later
// O-words: the subprograms, branches and loops of LinuxCNC's dialect, as syntax only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "core/nc/text/read_error.h"

namespace proveout {

enum class FlowKind : std::uint8_t {
    programNumber, ///< O alone: the name of a program, or the beginning of one for M98
    sub,
    endSub,
    call,
    returns,
    ifs,
    elseIf,
    elses,
    endIf,
    doLoop,
    whileLoop,
    endWhile,
    repeat,
    endRepeat,
    breaks,
    continues
};

/// The O-word of a line.
struct FlowWord {
    FlowKind kind = FlowKind::programNumber;
    std::string label;         ///< "100", or a name in lower case; empty if it has to be computed
    std::size_t labelAt = 0;   ///< of the label after the O, as an index into the line
    std::size_t begin = 0;     ///< of the O
    std::size_t arguments = 0; ///< index of the text after the keyword
};

/// Whether a line has an O-word, after "/" and N. Fast, because most lines have none.
[[nodiscard]] bool hasFlowWord(std::string_view line);

/// Reads the O-word of a line that has one.
[[nodiscard]] tl::expected<FlowWord, ReadError> readFlowWord(std::string_view line);

/// The keyword as programs write it.
[[nodiscard]] std::string_view keyword(FlowKind kind);

} // namespace proveout
