// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "core/nc/text/block.h"
#include "core/nc/text/parameters.h"

namespace proveout {

/// Where the calls and jumps of a block lead: set by the handlers of M98, M99, G65 and their like, carried
/// out when the block is done.
struct FlowRequest {
    enum class Kind : std::uint8_t {
        none,
        call,        ///< of a program by its number
        callLocal,   ///< of the blocks from a block number on
        macro,       ///< of a program, with arguments
        modalMacro,  ///< the same behind every motion that follows
        cancelModal, ///< ends that
        returns
    };
    Kind kind = Kind::none;
    int program = 0; ///< of returns: the block number that the caller goes on with, 0: behind its call
    int repeats = 1;
    Word word;                      ///< that asked for it
    Parameters::Locals arguments{}; ///< of macros
    std::string name{};             ///< of the program, instead of its number
};

} // namespace proveout
