// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/geometry.h"

namespace proveout {

/// The state of the control at one point of a program, in readable form. Names are marked with PROVEOUT_TEXT.
/// Value type.
struct ControlState {
    struct Mode {
        std::string code;  ///< "G54"
        const char* name;  ///< its meaning in the dialect
        const char* group; ///< its modal group
    };
    struct Place {
        const char* name;
        Vec3 value{0};          ///< mm
        std::uint8_t known = 0; ///< AxisBits
    };
    struct Quantity {
        const char* name;
        double value = 0;
        const char* unit; ///< "mm/min", or marked with PROVEOUT_TEXT: "rpm"
    };
    struct Variable {
        std::string name; ///< "#100", "#<depth>"
        double value = 0;
    };
    struct Call {
        std::string program;
        std::uint32_t line = 0; ///< 1-based, of the call
        std::string file;       ///< of that line; empty: the program's
    };

    std::uint32_t line = 0; ///< of the main text, executed last; 0: none
    std::vector<Mode> modes;
    std::vector<Place> places;
    std::vector<Quantity> quantities;
    std::vector<Variable> variables; ///< those that have been set
    std::vector<Call> calls;         ///< the outermost first
};

} // namespace proveout
