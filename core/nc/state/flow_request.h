// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "core/nc/text/block.h"
#include "core/nc/text/parameters.h"

namespace proveout {

/// The target of the calls and jumps of a block: set by the handlers of M98, M99, G65 and similar codes,
/// executed when the block is done.
struct FlowRequest {
    enum class Kind : std::uint8_t {
        none,
        call,        ///< a program by its number
        callLocal,   ///< the blocks from a block number on
        macro,       ///< a program, with arguments
        modalMacro,  ///< the same after every motion that follows
        cancelModal, ///< ends that
        returns
    };
    Kind kind = Kind::none;
    int program = 0; ///< for returns: the block number at which the caller continues, 0: after its call
    int repeats = 1;
    Word word;                      ///< the word that requested it
    Parameters::Locals arguments{}; ///< of macros
    std::string name{};             ///< of the program, instead of its number
};

} // namespace proveout
