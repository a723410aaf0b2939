// SPDX-License-Identifier: GPL-3.0-or-later
// The meaning of operators and functions in each macro language. Sources: LinuxCNC's documentation of
// expressions, checked against its stand-alone interpreter; FANUC's of custom macro B.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "core/nc/text/dialect.h"

namespace proveout {

/// The value of a parameter that was never set, if that is not 0.
inline constexpr double kNull = std::numeric_limits<double>::quiet_NaN();
[[nodiscard]] inline bool isNull(double value) {
    return std::isnan(value);
}

/// Nothing if an operation has no result.
using Outcome = std::optional<double>;

struct Operator {
    std::string_view word;
    int strength; ///< a larger value binds more tightly; 1 is the weakest
    Outcome (*apply)(double, double);
    bool seesNull = false; ///< otherwise null is treated as 0
};

struct Function {
    std::string_view word;
    Outcome (*apply)(double);
    bool toLeastUnit = false; ///< in the value of a word, rounds to the least increment of its letter
};

/// A function of two arguments.
struct PairFunction {
    std::string_view word;
    Outcome (*apply)(double, double);
    bool slash; ///< written F[a]/[b] too
    bool comma; ///< written F[a,b] too
    bool alone; ///< written F[a] too; the second argument is 1
};

struct ExpressionRules {
    std::span<const Operator> operators; ///< a word that is the beginning of another one comes after it
    std::span<const Function> functions; ///< in the same order
    std::span<const PairFunction> pairs;
    bool named;                ///< parameters may have names: #<name>, EXISTS
    bool repeatsSigns = false; ///< "- -#1" is #1
    bool checksAtEnd = false;  ///< an invalid number within brackets may still become valid
};

[[nodiscard]] const ExpressionRules& expressionRules(MacroLanguage language);

} // namespace proveout
