// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/diagnostic.h"

namespace proveout {

/// The variables of a condition, one row per letter.
struct ConditionVariable {
    char letter;
    const char* meaning; ///< for the user interface; marked with PROVEOUT_TEXT
};
inline constexpr std::size_t kConditionVariables = 8;
/// X Y Z F S T N L, in the order of ConditionValues.
[[nodiscard]] std::span<const ConditionVariable> conditionVariables();
/// NaN means unknown; no comparison with it holds.
using ConditionValues = std::array<double, kConditionVariables>;

/// A condition such as `Z < -20 && T == 3`: comparisons (< <= > >= == !=) of letters and numbers, joined by
/// && || ! and parentheses; && binds more tightly than ||. Case of letters is ignored. Value type.
class Condition {
public:
    /// Errors: one that names the column (1-based, bytes) and what was expected there. Any bytes are safe:
    /// the text may have at most kLongest of them, and at most kDeepest nested parentheses.
    [[nodiscard]] static Result<Condition> parse(std::string_view text);
    [[nodiscard]] bool holds(const ConditionValues& values) const;

    static constexpr std::size_t kLongest = 1000;
    static constexpr int kDeepest = 32;

private:
    friend class ConditionParser;

    enum class Action : std::uint8_t { compare, negate, both, either };
    enum class Comparison : std::uint8_t { less, lessOrEqual, greater, greaterOrEqual, equal, notEqual };
    struct Operand {
        int variable = -1; ///< -1 for a number
        double number = 0;
    };
    /// One step of a sequence in postfix order.
    struct Step {
        Action action;
        Comparison comparison = Comparison::less;
        Operand left;
        Operand right;
    };

    [[nodiscard]] static bool compare(const Step& step, const ConditionValues& values);

    std::vector<Step> m_steps;
};

} // namespace proveout
