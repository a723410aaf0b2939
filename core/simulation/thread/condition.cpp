// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/thread/condition.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <iterator>
#include <string>
#include <utility>

#include "core/base/text.h"
#include "core/simulation/thread/condition_findings.h"

namespace proveout {

namespace {

constexpr std::array<ConditionVariable, kConditionVariables> kVariables{{
    {'X', PROVEOUT_TEXT("Core", "position X at the end of the motion, mm")},
    {'Y', PROVEOUT_TEXT("Core", "position Y at the end of the motion, mm")},
    {'Z', PROVEOUT_TEXT("Core", "position Z at the end of the motion, mm")},
    {'F', PROVEOUT_TEXT("Core", "feed, mm/min; 0 at rapid")},
    {'S', PROVEOUT_TEXT("Core", "spindle speed, rpm")},
    {'T', PROVEOUT_TEXT("Core", "tool in the spindle")},
    {'N', PROVEOUT_TEXT("Core", "number of the block, as the timeline counts")},
    {'L', PROVEOUT_TEXT("Core", "line of the program")},
}};

char upper(char c) {
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

} // namespace

std::span<const ConditionVariable> conditionVariables() {
    return kVariables;
}

/// Parses a text from left to right; the first error ends it.
class ConditionParser {
public:
    explicit ConditionParser(std::string_view text) : m_text(text) {}

    Result<Condition> parse() {
        if (m_text.size() > Condition::kLongest)
            return failure(condition_finding::kConditionTooLong, {std::to_string(Condition::kLongest)});
        readEither();
        skipBlanks();
        if (m_error == nullptr && m_at < m_text.size())
            fail(condition_finding::kConditionJoin);
        if (m_error != nullptr)
            return failure(*m_error, {std::to_string(m_errorAt + 1)});
        return std::move(m_condition);
    }

private:
    using Action = Condition::Action;
    using Comparison = Condition::Comparison;

    void fail(const FindingRow& row) {
        if (m_error == nullptr) {
            m_error = &row;
            m_errorAt = m_at;
        }
    }

    void skipBlanks() {
        while (m_at < m_text.size() && (m_text[m_at] == ' ' || m_text[m_at] == '\t'))
            ++m_at;
    }

    bool accept(std::string_view token) {
        skipBlanks();
        if (!m_text.substr(m_at).starts_with(token))
            return false;
        m_at += token.size();
        return true;
    }

    void readEither() {
        readBoth();
        while (m_error == nullptr && accept("||")) {
            readBoth();
            m_condition.m_steps.push_back({Action::either, {}, {}, {}});
        }
    }

    void readBoth() {
        readOne();
        while (m_error == nullptr && accept("&&")) {
            readOne();
            m_condition.m_steps.push_back({Action::both, {}, {}, {}});
        }
    }

    void readOne() {
        // Each `!` negates what follows it; they are counted instead of recursing.
        bool negated = false;
        for (skipBlanks(); m_text.substr(m_at).starts_with('!'); skipBlanks()) {
            negated = !negated;
            ++m_at;
        }
        if (accept("("))
            readGroup();
        else
            readComparison();
        if (negated)
            m_condition.m_steps.push_back({Action::negate, {}, {}, {}});
    }

    void readGroup() {
        if (++m_depth > Condition::kDeepest)
            return fail(condition_finding::kConditionDepth);
        readEither();
        if (m_error == nullptr && !accept(")"))
            fail(condition_finding::kConditionParenthesis);
        --m_depth;
    }

    void readComparison() {
        Condition::Step step{Action::compare, {}, readOperand(), {}};
        // Longer operators come first.
        constexpr std::array<std::pair<std::string_view, Comparison>, 6> kComparisons{{
            {"<=", Comparison::lessOrEqual},
            {">=", Comparison::greaterOrEqual},
            {"==", Comparison::equal},
            {"!=", Comparison::notEqual},
            {"<", Comparison::less},
            {">", Comparison::greater},
        }};
        const auto* const found =
            std::ranges::find_if(kComparisons, [this](const auto& row) { return accept(row.first); });
        if (found == kComparisons.end())
            return fail(condition_finding::kConditionComparison);
        step.comparison = found->second;
        step.right = readOperand();
        m_condition.m_steps.push_back(step);
    }

    Condition::Operand readOperand() {
        skipBlanks();
        const std::string_view rest = m_text.substr(m_at);
        if (rest.empty()) {
            fail(condition_finding::kConditionOperand);
            return {};
        }
        const auto variable = std::ranges::find(kVariables, upper(rest.front()), &ConditionVariable::letter);
        if (variable != kVariables.end()) {
            ++m_at;
            return {static_cast<int>(std::distance(kVariables.begin(), variable)), 0};
        }
        // "inf" and "nan" are not accepted: a number must begin with a digit or a point.
        const std::size_t sign = rest.front() == '-' || rest.front() == '+' ? 1 : 0;
        const char first = rest.size() > sign ? rest[sign] : ' ';
        double number = 0;
        const char* begin = rest.data() + (rest.front() == '+' ? 1 : 0);
        const auto [end, error] = std::from_chars(begin, rest.data() + rest.size(), number);
        if (error != std::errc() || !((first >= '0' && first <= '9') || first == '.')) {
            fail(condition_finding::kConditionOperand);
            return {};
        }
        m_at += static_cast<std::size_t>(end - rest.data());
        return {-1, number};
    }

    std::string_view m_text;
    std::size_t m_at = 0;
    int m_depth = 0;
    const FindingRow* m_error = nullptr;
    std::size_t m_errorAt = 0;
    Condition m_condition;
};

Result<Condition> Condition::parse(std::string_view text) {
    return ConditionParser(text).parse();
}

bool Condition::compare(const Step& step, const ConditionValues& values) {
    const auto value = [&](const Operand& operand) {
        return operand.variable < 0 ? operand.number : values[static_cast<std::size_t>(operand.variable)];
    };
    const double left = value(step.left);
    const double right = value(step.right);
    switch (step.comparison) {
    case Comparison::less:
        return left < right;
    case Comparison::lessOrEqual:
        return left <= right;
    case Comparison::greater:
        return left > right;
    case Comparison::greaterOrEqual:
        return left >= right;
    case Comparison::equal:
        return left == right;
    case Comparison::notEqual:
        return left < right || left > right; // false if one is not known
    }
    return false;
}

bool Condition::holds(const ConditionValues& values) const {
    // Each level of parentheses leaves at most two operands waiting.
    std::array<bool, std::size_t{3} * (kDeepest + 1)> stack{};
    std::size_t top = 0;
    for (const Step& step : m_steps) {
        switch (step.action) {
        case Action::compare:
            assert(top < stack.size());
            stack[top++] = compare(step, values);
            break;
        case Action::negate:
            stack[top - 1] = !stack[top - 1];
            break;
        case Action::both:
            --top;
            stack[top - 1] = stack[top - 1] && stack[top];
            break;
        case Action::either:
            --top;
            stack[top - 1] = stack[top - 1] || stack[top];
            break;
        }
    }
    return top > 0 && stack[top - 1];
}

} // namespace proveout
