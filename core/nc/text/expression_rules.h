// SPDX-License-Identifier: GPL-3.0-or-later
// What operators and functions mean, by language of macros. Sources: LinuxCNC's documentation of expressions,
// checked against its stand-alone interpreter; FANUC's of custom macro B.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "core/nc/text/dialect.h"

namespace proveout {

/// The value of a parameter that was never set, where that is not 0.
inline constexpr double kNull = std::numeric_limits<double>::quiet_NaN();
[[nodiscard]] inline bool isNull(double value) {
    return std::isnan(value);
}

/// Nothing where an operation has no result.
using Outcome = std::optional<double>;

struct Operator {
    std::string_view word;
    int strength; ///< the larger binds first; 1 is the weakest
    Outcome (*apply)(double, double);
    bool seesNull = false; ///< otherwise null counts as 0
};

struct Function {
    std::string_view word;
    Outcome (*apply)(double);
    bool toLeastUnit = false; ///< in the value of a word, counts in the least units of its letter
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
    std::span<const Operator> operators; ///< a word that begins another one stands behind it
    std::span<const Function> functions; ///< likewise
    std::span<const PairFunction> pairs;
    bool named;                ///< parameters have names too: #<name>, EXISTS
    bool repeatsSigns = false; ///< "- -#1" is #1
    bool checksAtEnd = false;  ///< what is no number within brackets may still become one
};

[[nodiscard]] const ExpressionRules& expressionRules(MacroLanguage language);

} // namespace proveout
