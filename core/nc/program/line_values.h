// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/nc/codes/codes.h"
#include "core/nc/program/control_state.h"

namespace proveout {

/// The meaning of a line of the main text at its first execution, for tooltips. Value type.
struct LineValues {
    /// A word as the control interprets it.
    struct Value {
        std::size_t begin = 0; ///< as an index into the line
        double value = 0;      ///< in the unit of the program; the increments of a length without a decimal
                               ///< point are converted
        Quantity quantity = Quantity::number;
        const char* unit = ""; ///< "mm", or marked with PROVEOUT_TEXT: "rpm"
    };
    struct Parameter {
        std::size_t begin = 0;        ///< position of its "#"
        std::optional<double> before; ///< nothing: it was not set, or cannot be read
        std::optional<double> after;
    };

    std::uint32_t line = 0;     ///< 1-based
    std::size_t executions = 0; ///< up to the point where the program was run; 0: it was not reached
    std::vector<Value> words;
    std::vector<Parameter> parameters;
    std::vector<ControlState::Mode> before; ///< the codes in force
    std::vector<ControlState::Mode> after;
};

} // namespace proveout
