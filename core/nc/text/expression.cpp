// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/text/expression.h"

#include <cmath>
#include <fmt/format.h>

#include "core/nc/text/characters.h"
#include "core/nc/text/number.h"

namespace proveout {

namespace {

using Value = tl::expected<double, ReadError>;

constexpr double kWhole = 1e-4; ///< numbers nearer to a whole number than this count as whole
constexpr int kWeakest = 1;

double numberOf(double value) {
    return isNull(value) ? 0 : value;
}

const FindingRow& messageFor(NumberStatus status) {
    switch (status) {
    case NumberStatus::doubleSign:
        return nc_message::kDoubleSign;
    case NumberStatus::twoPoints:
        return nc_message::kTwoPoints;
    case NumberStatus::outOfRange:
        return nc_message::kNumberOutOfRange;
    default:
        return nc_message::kNumberMissing;
    }
}

tl::unexpected<ReadError> fail(const FindingRow& message, std::size_t begin, std::size_t end,
                               std::string_view argument = {}) {
    return tl::unexpected(readError(message, begin, end, argument));
}

/// Counts the open levels of an expression during its lifetime.
class Level {
public:
    explicit Level(int& depth) : m_depth(++depth) {}
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;
    ~Level() { --m_depth; }

private:
    int& m_depth;
};

} // namespace

char ExpressionReader::peek(std::size_t& at) const {
    while (at < m_line.size() && isBlank(m_line[at]))
        ++at;
    return at < m_line.size() ? upperCase(m_line[at]) : '\0';
}

bool ExpressionReader::accept(std::size_t& at, std::string_view word) const {
    std::size_t next = at;
    for (const char c : word) {
        if (peek(next) != c)
            return false;
        ++next;
    }
    at = next;
    return true;
}

Value ExpressionReader::value(std::size_t& at, std::string_view letter) {
    const std::size_t begin = at;
    return inRange(signedValue(at, letter), begin, at, letter);
}

Value ExpressionReader::expression(std::size_t& at, std::string_view letter) {
    const std::size_t begin = at;
    const Value left = signedValue(at, letter);
    return inRange(left ? operation(*left, at, kWeakest) : left, begin, at, letter);
}

Value ExpressionReader::inRange(const Value& value, std::size_t begin, std::size_t end,
                                std::string_view letter) const {
    if (value && !(std::abs(numberOf(*value)) <= kLargestNumber))
        return fail(nc_message::kNumberOutOfRange, begin, end, letter);
    return value;
}

Value ExpressionReader::signedValue(std::size_t& at, std::string_view letter) {
    const std::size_t begin = at;
    const Level level(m_depth);
    if (m_depth > kDeepest)
        return fail(nc_message::kNestedTooDeep, begin, begin + 1);
    const char first = peek(at);
    if (first == '#')
        return parameter(++at);
    if (first == '[')
        return bracket(++at);
    if (isCapital(first))
        return function(at, letter);
    if (first != '-' && first != '+')
        return plainNumber(at, letter);
    std::size_t behind = at + 1;
    const char next = peek(behind);
    const bool again = m_rules.repeatsSigns && (next == '-' || next == '+');
    if (next != '#' && next != '[' && !isCapital(next) && !again)
        return plainNumber(at, letter);
    at = behind;
    const Value value = signedValue(at, letter);
    return value && first == '-' ? Value(-*value) : value;
}

Value ExpressionReader::plainNumber(std::size_t& at, std::string_view letter) {
    const NumberRead number = readNumber(m_line, at);
    if (number.status == NumberStatus::good) {
        at = number.end;
        return number.value;
    }
    return fail(messageFor(number.status), number.place, number.place + 1, letter);
}

Value ExpressionReader::parameter(std::size_t& at) {
    const std::size_t begin = at - 1;
    const tl::expected<ParameterName, ReadError> name = parameterName(at);
    if (!name)
        return tl::unexpected(name.error());
    if (const FindingRow* refusal = name->name.empty() ? m_system.refusal(name->number) : nullptr) {
        m_system.noteUse();
        return fail(*refusal, begin, at, m_line.substr(begin, at - begin));
    }
    const auto ofSystem = name->name.empty() ? m_system.numbered(name->number) : m_system.named(name->name);
    if (ofSystem) {
        m_system.noteUse();
        return *ofSystem;
    }
    if (name->name.empty()) {
        return m_parameters.exists(name->number) ? m_parameters.numbered(name->number) : kNull;
    }
    if (const auto value = m_parameters.named(name->name))
        return *value;
    return fail(nc_message::kParameterUnset, begin, at, m_line.substr(begin, at - begin));
}

tl::expected<ParameterName, ReadError> ExpressionReader::parameterName(std::size_t& at) {
    const std::size_t begin = at;
    if (m_rules.named && peek(at) == '<') {
        const auto name = quotedName(at);
        return name ? tl::expected<ParameterName, ReadError>({0, *name}) : tl::unexpected(name.error());
    }
    const Value number = signedValue(at, "#");
    if (!number)
        return tl::unexpected(number.error());
    const double whole = std::round(numberOf(*number));
    if (std::abs(numberOf(*number) - whole) > kWhole)
        return fail(nc_message::kParameterNotWhole, begin, at, m_line.substr(begin, at - begin));
    const bool small = whole >= 0 && whole <= Parameters::kLargest;
    const int index = small ? static_cast<int>(whole) : -1;
    // The value is evaluated last, because that counts as reading it.
    if (!small || !(m_parameters.exists(index) || m_system.writable(index) || m_system.refusal(index) ||
                    m_system.numbered(index)))
        return fail(nc_message::kParameterNumber, begin, at, m_line.substr(begin, at - begin));
    return ParameterName{index, {}};
}

tl::expected<std::string, ReadError> ExpressionReader::quotedName(std::size_t& at) {
    const std::size_t begin = at;
    const std::size_t end = m_line.find('>', begin);
    if (end == std::string_view::npos)
        return fail(nc_message::kNameUnclosed, begin, m_line.size());
    std::string name;
    for (const char c : m_line.substr(begin + 1, end - begin - 1)) {
        if (!isBlank(c))
            name.push_back(lowerCase(c));
    }
    at = end + 1;
    if (name.empty())
        return fail(nc_message::kNameEmpty, begin, at);
    if (name.size() > Parameters::kLongestName)
        return fail(nc_message::kNameLong, begin, at);
    return name;
}

Value ExpressionReader::bracket(std::size_t& at) {
    const std::size_t open = at - 1;
    const Value value = bracketed(at);
    const Value result = value ? closed(*value, open, at) : value;
    if (result && m_rules.checksAtEnd && !std::isfinite(*result))
        return fail(nc_message::kNoResult, open, at, m_line.substr(open, at - open));
    return result;
}

/// The contents of an open bracket.
Value ExpressionReader::bracketed(std::size_t& at) {
    const Level level(m_brackets);
    if (m_deepestBrackets > 0 && m_brackets > m_deepestBrackets)
        return fail(nc_message::kBracketsTooDeep, at - 1, at);
    return operand(at, kWeakest);
}

Value ExpressionReader::closed(double value, std::size_t open, std::size_t& at) {
    if (peek(at) == ']') {
        ++at;
        return value;
    }
    if (at >= m_line.size())
        return fail(nc_message::kBracketUnclosed, open, open + 1);
    return fail(nc_message::kOperatorMissing, at, at + 1, m_line.substr(at, 1));
}

Value ExpressionReader::operand(std::size_t& at, int strength) {
    const Value left = signedValue(at, "[");
    return left ? operation(*left, at, strength) : left;
}

Value ExpressionReader::operation(double left, std::size_t& at, int strength) {
    for (;;) {
        std::size_t place = at;
        static_cast<void>(peek(place));
        const Operator* found = nullptr;
        for (const Operator& row : m_rules.operators) {
            std::size_t behind = at;
            if (accept(behind, row.word)) {
                found = &row;
                break;
            }
        }
        if (found == nullptr || found->strength < strength)
            return left;
        accept(at, found->word);
        const Value right = operand(at, found->strength + 1);
        if (!right)
            return right;
        const Outcome result = found->seesNull || m_rules.checksAtEnd
                                   ? found->apply(left, *right)
                                   : found->apply(numberOf(left), numberOf(*right));
        if (!result || (!m_rules.checksAtEnd && !std::isfinite(*result)))
            return fail(nc_message::kNoResult, place, at, m_line.substr(place, at - place));
        left = *result;
    }
}

/// The row of a table that matches at `at`, which is then moved to after it; null if there is none.
template<class Row>
const Row* ExpressionReader::accepted(std::span<const Row> rows, std::size_t& at) const {
    for (const Row& row : rows) {
        if (accept(at, row.word))
            return &row;
    }
    return nullptr;
}

Value ExpressionReader::function(std::size_t& at, std::string_view letter) {
    const std::size_t begin = at;
    if (m_rules.named && accept(at, "EXISTS"))
        return existence(at);
    if (const PairFunction* pair = accepted(m_rules.pairs, at))
        return ofPair(*pair, begin, at);
    const Function* found = accepted(m_rules.functions, at);
    if (found == nullptr)
        return fail(nc_message::kNumberMissing, begin, begin + 1, letter);
    if (peek(at) != '[')
        return fail(nc_message::kBracketMissing, begin, at, m_line.substr(begin, at - begin));
    const Value argument = bracket(++at);
    if (!argument)
        return argument;
    const double unit = found->toLeastUnit ? m_leastUnit : 1;
    const Outcome result = found->apply(numberOf(*argument) / unit);
    if (!result || !std::isfinite(*result))
        return fail(nc_message::kNoResult, begin, at, m_line.substr(begin, at - begin));
    return *result * unit;
}

/// ATAN[y]/[x] and similar functions; `at` is after the name.
Value ExpressionReader::ofPair(const PairFunction& function, std::size_t begin, std::size_t& at) {
    if (peek(at) != '[')
        return fail(nc_message::kBracketMissing, begin, at, m_line.substr(begin, at - begin));
    const std::size_t open = at++;
    const Value first = bracketed(at);
    if (!first)
        return first;
    Value second = 1.0;
    if (function.comma && peek(at) == ',') {
        second = bracketed(++at);
        if (second)
            second = closed(*second, open, at);
    } else if (const Value end = closed(*first, open, at); !end) {
        return end;
    } else if (std::size_t behind = at; function.slash && accept(behind, "/") && peek(behind) == '[') {
        at = behind + 1;
        second = bracket(at);
    } else if (!function.alone) {
        return fail(nc_message::kPairForm, begin, at, function.word);
    }
    if (!second)
        return second;
    const Outcome result = m_rules.checksAtEnd ? function.apply(*first, *second)
                                               : function.apply(numberOf(*first), numberOf(*second));
    if (!result || !std::isfinite(*result))
        return fail(nc_message::kNoResult, begin, at, m_line.substr(begin, at - begin));
    return *result;
}

/// EXISTS[#<name>]; for a number, whether there is such a parameter.
Value ExpressionReader::existence(std::size_t& at) {
    const std::size_t begin = at;
    if (!accept(at, "[") || !accept(at, "#"))
        return fail(nc_message::kExistsForm, begin, begin + 1);
    bool exists = false;
    if (peek(at) == '<') {
        const auto name = quotedName(at);
        if (!name)
            return tl::unexpected(name.error());
        exists = m_system.named(*name).has_value() || m_parameters.named(*name).has_value();
    } else {
        const Value number = signedValue(at, "#");
        if (!number)
            return number;
        exists =
            *number >= 1 && *number <= Parameters::kLargest && m_parameters.exists(static_cast<int>(*number));
    }
    if (peek(at) != ']')
        return fail(nc_message::kBracketUnclosed, begin, begin + 1);
    ++at;
    return exists ? 1.0 : 0.0;
}

} // namespace proveout
