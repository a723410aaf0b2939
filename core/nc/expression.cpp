// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/expression.h"

#include <cmath>
#include <numbers>

#include "core/nc/characters.h"
#include "core/nc/number.h"

namespace proveout {

namespace {

using Value = tl::expected<double, ReadError>;

constexpr double kEqual = 1e-4; ///< LinuxCNC takes numbers nearer than this for equal, and for whole
constexpr int kWeakest = 1;

bool isLetter(char c) {
    return c >= 'A' && c <= 'Z';
}

double radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}

double degrees(double radians) {
    return radians * 180 / std::numbers::pi;
}

/// Nothing where an operation has no result.
using Outcome = std::optional<double>;

double truth(bool value) {
    return value ? 1.0 : 0.0;
}

Outcome dividedBy(double left, double right) {
    return right == 0 ? Outcome() : left / right;
}

Outcome modulo(double left, double right) {
    if (right == 0)
        return {};
    const double rest = std::fmod(left, right);
    return rest < 0 ? rest + std::abs(right) : rest;
}

Outcome power(double left, double right) {
    return left < 0 && right != std::floor(right) ? Outcome() : std::pow(left, right);
}

struct Operator {
    std::string_view word;
    int strength; ///< the larger binds first
    Outcome (*apply)(double, double);
};

// A word that begins another one stands behind it.
constexpr Operator kOperators[] = {
    {"**", 5, power},
    {"*", 4, [](double l, double r) { return Outcome(l * r); }},
    {"/", 4, dividedBy},
    {"MOD", 4, modulo},
    {"+", 3, [](double l, double r) { return Outcome(l + r); }},
    {"-", 3, [](double l, double r) { return Outcome(l - r); }},
    {"EQ", 2, [](double l, double r) { return Outcome(truth(std::abs(l - r) < kEqual)); }},
    {"NE", 2, [](double l, double r) { return Outcome(truth(std::abs(l - r) >= kEqual)); }},
    {"GT", 2, [](double l, double r) { return Outcome(truth(l > r)); }},
    {"GE", 2, [](double l, double r) { return Outcome(truth(l >= r)); }},
    {"LT", 2, [](double l, double r) { return Outcome(truth(l < r)); }},
    {"LE", 2, [](double l, double r) { return Outcome(truth(l <= r)); }},
    {"AND", 1, [](double l, double r) { return Outcome(truth(l != 0 && r != 0)); }},
    {"OR", 1, [](double l, double r) { return Outcome(truth(l != 0 || r != 0)); }},
    {"XOR", 1, [](double l, double r) { return Outcome(truth((l != 0) != (r != 0))); }},
};

Outcome arcSine(double x) {
    return std::abs(x) > 1 ? Outcome() : degrees(std::asin(x));
}

Outcome arcCosine(double x) {
    return std::abs(x) > 1 ? Outcome() : degrees(std::acos(x));
}

struct Function {
    std::string_view word;
    Outcome (*apply)(double);
};

// ATAN and EXISTS have arguments of another form.
constexpr Function kFunctions[] = {
    {"ABS", [](double x) { return Outcome(std::abs(x)); }},
    {"ACOS", arcCosine},
    {"ASIN", arcSine},
    {"COS", [](double x) { return Outcome(std::cos(radians(x))); }},
    {"EXP", [](double x) { return Outcome(std::exp(x)); }},
    {"FIX", [](double x) { return Outcome(std::floor(x)); }},
    {"FUP", [](double x) { return Outcome(std::ceil(x)); }},
    {"LN", [](double x) { return x <= 0 ? Outcome() : std::log(x); }},
    {"ROUND", [](double x) { return Outcome(std::trunc(x + (x < 0 ? -0.5 : 0.5))); }},
    {"SIN", [](double x) { return Outcome(std::sin(radians(x))); }},
    {"SQRT", [](double x) { return x < 0 ? Outcome() : std::sqrt(x); }},
    {"TAN", [](double x) { return Outcome(std::tan(radians(x))); }},
};

const Message& messageFor(NumberStatus status) {
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

tl::unexpected<ReadError> fail(const Message& message, std::size_t begin, std::size_t end,
                               std::string_view argument = {}) {
    return tl::unexpected(readError(message, begin, end, argument));
}

/// Counts the levels of an expression while it stands.
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

bool ExpressionReader::take(std::size_t& at, std::string_view word) const {
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
    const Value value = signedValue(at, letter);
    if (value && !(std::abs(*value) <= kLargestNumber))
        return fail(nc_message::kNumberOutOfRange, begin, at, letter);
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
    if (isLetter(first))
        return function(at, letter);
    if (first != '-' && first != '+')
        return plainNumber(at, letter);
    std::size_t behind = at + 1;
    const char next = peek(behind);
    if (next != '#' && next != '[' && !isLetter(next))
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
    if (name->name.empty() && m_system.hidden(name->number))
        return fail(nc_message::kPositionHidden, begin, at, m_line.substr(begin, at - begin));
    if (name->name.empty())
        return m_system.numbered(name->number).value_or(m_parameters.numbered(name->number));
    if (const auto value = m_system.named(name->name))
        return *value;
    if (const auto value = m_parameters.named(name->name))
        return *value;
    return fail(nc_message::kParameterUnset, begin, at, m_line.substr(begin, at - begin));
}

tl::expected<ParameterName, ReadError> ExpressionReader::parameterName(std::size_t& at) {
    const std::size_t begin = at;
    if (peek(at) == '<') {
        const auto name = quotedName(at);
        return name ? tl::expected<ParameterName, ReadError>({0, *name}) : tl::unexpected(name.error());
    }
    const Value number = signedValue(at, "#");
    if (!number)
        return tl::unexpected(number.error());
    const double whole = std::round(*number);
    if (std::abs(*number - whole) > kEqual)
        return fail(nc_message::kParameterNotWhole, begin, at, m_line.substr(begin, at - begin));
    if (!(whole >= 1 && whole < Parameters::kMost))
        return fail(nc_message::kParameterNumber, begin, at, m_line.substr(begin, at - begin));
    return ParameterName{static_cast<int>(whole), {}};
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
    const Value value = operand(at, kWeakest);
    if (!value)
        return value;
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
        for (const Operator& row : kOperators) {
            std::size_t behind = at;
            if (take(behind, row.word)) {
                found = &row;
                break;
            }
        }
        if (found == nullptr || found->strength < strength)
            return left;
        take(at, found->word);
        const Value right = operand(at, found->strength + 1);
        if (!right)
            return right;
        const Outcome result = found->apply(left, *right);
        if (!result || !std::isfinite(*result))
            return fail(nc_message::kNoResult, place, at, m_line.substr(place, at - place));
        left = *result;
    }
}

Value ExpressionReader::function(std::size_t& at, std::string_view letter) {
    const std::size_t begin = at;
    if (take(at, "EXISTS"))
        return existence(at);
    const bool arcTan = take(at, "ATAN");
    const Function* found = nullptr;
    for (const Function& row : kFunctions) {
        if (!arcTan && take(at, row.word)) {
            found = &row;
            break;
        }
    }
    if (!arcTan && found == nullptr)
        return fail(nc_message::kNumberMissing, begin, begin + 1, letter);
    if (peek(at) != '[')
        return fail(nc_message::kBracketMissing, begin, at, m_line.substr(begin, at - begin));
    const Value argument = bracket(++at);
    if (!argument)
        return argument;
    if (arcTan)
        return arcTangent(*argument, at);
    const Outcome result = found->apply(*argument);
    if (!result || !std::isfinite(*result))
        return fail(nc_message::kNoResult, begin, at, m_line.substr(begin, at - begin));
    return *result;
}

/// ATAN[y]/[x]
Value ExpressionReader::arcTangent(double opposite, std::size_t& at) {
    const std::size_t begin = at;
    if (!take(at, "/") || peek(at) != '[')
        return fail(nc_message::kArcTangentForm, begin, begin + 1);
    const Value adjacent = bracket(++at);
    return adjacent ? Value(degrees(std::atan2(opposite, *adjacent))) : adjacent;
}

/// EXISTS[#<name>]; of a number, whether there is such a parameter.
Value ExpressionReader::existence(std::size_t& at) {
    const std::size_t begin = at;
    if (!take(at, "[") || !take(at, "#"))
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
        exists = *number >= 1 && *number < Parameters::kMost;
    }
    if (peek(at) != ']')
        return fail(nc_message::kBracketUnclosed, begin, begin + 1);
    ++at;
    return truth(exists);
}

} // namespace proveout
