// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers, parameters and expressions as written in an NC line.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "core/nc/text/expression_rules.h"
#include "core/nc/text/parameters.h"
#include "core/nc/text/read_error.h"

namespace proveout {

/// A parameter that a line names: by number, or by name if `name` is not empty.
struct ParameterName {
    int number = 0;
    std::string name; ///< lower case, without blanks

    bool operator==(const ParameterName&) const = default;
};

/// The data with which expressions are evaluated.
struct ReadContext {
    const Parameters& parameters;
    const SystemValues& system;
    const Dialect& dialect;
    bool blockDelete = false; ///< text after a "/" within a block is skipped
};

/// Reads values from one line. Blanks are allowed anywhere, case is ignored. Keeps references to its
/// arguments. The length of the line must have been checked before: the time is linear in it.
class ExpressionReader {
public:
    static constexpr int kDeepest = 100; ///< levels of brackets, signs and parameters of parameters

    ExpressionReader(std::string_view line, const ReadContext& context)
        : m_line(line), m_parameters(context.parameters), m_system(context.system),
          m_rules(expressionRules(context.dialect.macros)),
          m_deepestBrackets(context.dialect.deepestBrackets) {}

    /// The value that begins at `at`, which is then moved to after it: a number, a parameter, a bracket or a
    /// function, with or without a sign; kNull is a value if the dialect has null. `letter` is the word that
    /// messages name.
    [[nodiscard]] tl::expected<double, ReadError> value(std::size_t& at, std::string_view letter);

    /// The value of the expression that begins at `at`, which needs no brackets around it.
    [[nodiscard]] tl::expected<double, ReadError> expression(std::size_t& at, std::string_view letter);

    /// The least increment of the letter whose value is read: ROUND uses it, if the dialect requires that.
    void setLeastUnit(double unit) { m_leastUnit = unit; }

    /// The name after "#"; `at` points to it, and then after it.
    [[nodiscard]] tl::expected<ParameterName, ReadError> parameterName(std::size_t& at);

private:
    using Value = tl::expected<double, ReadError>;

    [[nodiscard]] char peek(std::size_t& at) const; ///< upper case, after blanks; 0 at the end
    bool accept(std::size_t& at, std::string_view word) const;
    [[nodiscard]] Value inRange(const Value& value, std::size_t begin, std::size_t end,
                                std::string_view letter) const;
    Value signedValue(std::size_t& at, std::string_view letter);
    Value plainNumber(std::size_t& at, std::string_view letter);
    Value parameter(std::size_t& at);
    Value bracket(std::size_t& at);
    Value bracketed(std::size_t& at);
    Value operand(std::size_t& at, int strength);
    Value operation(double left, std::size_t& at, int strength);
    Value function(std::size_t& at, std::string_view letter);
    Value ofPair(const PairFunction& function, std::size_t begin, std::size_t& at);
    Value closed(double value, std::size_t open, std::size_t& at);
    template<class Row>
    const Row* accepted(std::span<const Row> rows, std::size_t& at) const;
    Value existence(std::size_t& at);
    tl::expected<std::string, ReadError> quotedName(std::size_t& at);

    std::string_view m_line;
    const Parameters& m_parameters;
    const SystemValues& m_system;
    const ExpressionRules& m_rules;
    double m_leastUnit = 1;
    int m_depth = 0;
    int m_deepestBrackets;
    int m_brackets = 0; ///< number of open brackets
};

} // namespace proveout
