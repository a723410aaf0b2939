// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/text/expression_rules.h"

#include <cstdint>
#include <numbers>

namespace proveout {

namespace {

constexpr double kEqual = 1e-4;      ///< LinuxCNC treats numbers nearer than this as equal
constexpr double kAlike = 1e-9;      ///< custom macro B: finer than its eight digits
constexpr double kFullTurn = 360;    ///< degrees
constexpr double kLargestWord = 2e9; ///< in operations on bits

// As LinuxCNC rounds: MOD amplifies the last bit of a large number.
constexpr long double kPi = std::numbers::pi_v<long double>;

double radians(double degrees) {
    return static_cast<double>(static_cast<long double>(degrees) * kPi / 180);
}

double degrees(double radians) {
    return static_cast<double>(static_cast<long double>(radians * 180) / kPi);
}

double truth(bool value) {
    return value ? 1.0 : 0.0;
}

Outcome add(double left, double right) {
    return left + right;
}

Outcome subtract(double left, double right) {
    return left - right;
}

Outcome multiply(double left, double right) {
    return left * right;
}

Outcome divide(double left, double right) {
    return right == 0 ? Outcome() : left / right;
}

Outcome greater(double left, double right) {
    return truth(left > right);
}

Outcome greaterOrEqual(double left, double right) {
    return truth(left >= right);
}

Outcome less(double left, double right) {
    return truth(left < right);
}

Outcome lessOrEqual(double left, double right) {
    return truth(left <= right);
}

/// The result is never negative, even for a negative divisor. With divisor 0 it is not a number.
Outcome modulo(double left, double right) {
    const double rest = std::fmod(left, right);
    return rest < 0 ? rest + std::abs(right) : rest;
}

/// The result has the sign of the dividend.
Outcome remainder(double left, double right) {
    return right == 0 ? Outcome() : std::fmod(left, right);
}

Outcome power(double left, double right) {
    return left < 0 && right != std::floor(right) ? Outcome() : std::pow(left, right);
}

constexpr Operator kOWordOperators[] = {
    {"**", 5, power},
    {"*", 4, multiply},
    {"/", 4, divide},
    {"MOD", 4, modulo},
    {"+", 3, add},
    {"-", 3, subtract},
    {"EQ", 2, [](double l, double r) { return Outcome(truth(std::abs(l - r) < kEqual)); }},
    {"NE", 2, [](double l, double r) { return Outcome(truth(std::abs(l - r) >= kEqual)); }},
    {"GT", 2, greater},
    {"GE", 2, greaterOrEqual},
    {"LT", 2, less},
    {"LE", 2, lessOrEqual},
    {"AND", 1, [](double l, double r) { return Outcome(truth(l != 0 && r != 0)); }},
    {"OR", 1, [](double l, double r) { return Outcome(truth(l != 0 || r != 0)); }},
    {"XOR", 1, [](double l, double r) { return Outcome(truth((l != 0) != (r != 0))); }},
};

/// Custom macro B works on the bits of whole numbers.
template<class Operation>
Outcome onBits(double left, double right, Operation operation) {
    if (std::abs(left) > kLargestWord || std::abs(right) > kLargestWord)
        return {};
    return static_cast<double>(operation(std::llround(left), std::llround(right)));
}

/// Null equals only null, not even 0.
bool alike(double left, double right) {
    if (isNull(left) || isNull(right))
        return isNull(left) && isNull(right);
    return std::abs(left - right) <= kAlike * std::fmax(1, std::fmax(std::abs(left), std::abs(right)));
}

constexpr Operator kMacroBOperators[] = {
    {"*", 4, multiply},
    {"/", 4, divide},
    {"AND", 4,
     [](double l, double r) { return onBits(l, r, [](std::int64_t a, std::int64_t b) { return a & b; }); }},
    {"MOD", 4, remainder},
    {"+", 3, add},
    {"-", 3, subtract},
    {"OR", 3,
     [](double l, double r) { return onBits(l, r, [](std::int64_t a, std::int64_t b) { return a | b; }); }},
    {"XOR", 3,
     [](double l, double r) { return onBits(l, r, [](std::int64_t a, std::int64_t b) { return a ^ b; }); }},
    {"EQ", 1, [](double l, double r) { return Outcome(truth(alike(l, r))); }, true},
    {"NE", 1, [](double l, double r) { return Outcome(truth(!alike(l, r))); }, true},
    {"GT", 1, greater},
    {"GE", 1, greaterOrEqual},
    {"LT", 1, less},
    {"LE", 1, lessOrEqual},
};

Outcome absolute(double x) {
    return std::abs(x);
}

Outcome arcSine(double x) {
    return std::abs(x) > 1 ? Outcome() : degrees(std::asin(x));
}

Outcome arcCosine(double x) {
    return std::abs(x) > 1 ? Outcome() : degrees(std::acos(x));
}

Outcome sine(double x) {
    return std::sin(radians(x));
}

Outcome cosine(double x) {
    return std::cos(radians(x));
}

Outcome tangent(double x) {
    return std::tan(radians(x));
}

Outcome exponential(double x) {
    return std::exp(x);
}

Outcome logarithm(double x) {
    return x <= 0 ? Outcome() : std::log(x);
}

Outcome squareRoot(double x) {
    return x < 0 ? Outcome() : std::sqrt(x);
}

/// To the nearest whole number, halves away from 0.
Outcome nearest(double x) {
    return std::trunc(x + (x < 0 ? -0.5 : 0.5));
}

constexpr Function kOWordFunctions[] = {
    {"ABS", absolute},
    {"ACOS", arcCosine},
    {"ASIN", arcSine},
    {"COS", cosine},
    {"EXP", exponential},
    {"FIX", [](double x) { return Outcome(std::floor(x)); }},
    {"FUP", [](double x) { return Outcome(std::ceil(x)); }},
    {"LN", logarithm},
    {"ROUND", nearest},
    {"SIN", sine},
    {"SQRT", squareRoot},
    {"TAN", tangent},
};

constexpr PairFunction kOWordPairs[] = {
    {"ATAN", [](double y, double x) { return Outcome(degrees(std::atan2(y, x))); }, true, false, false},
};

/// Angles of custom macro B go from 0 to 360 degrees (parameter 6004#0 = 0).
double positive(double angle) {
    return angle < 0 ? angle + kFullTurn : angle;
}

/// The digits of a number as groups of four bits, and back.
Outcome binaryCoded(double x) {
    if (x < 0 || x >= 1e8)
        return {};
    double coded = 0;
    double place = 1;
    for (auto rest = std::llround(x); rest > 0; rest /= 10, place *= 16)
        coded += static_cast<double>(rest % 10) * place;
    return coded;
}

Outcome fromBinaryCoded(double x) {
    if (x < 0 || x > 4.29e9)
        return {};
    double value = 0;
    double place = 1;
    for (auto rest = std::llround(x); rest > 0; rest /= 16, place *= 10)
        value += static_cast<double>(rest % 16) * place;
    return value;
}

constexpr Function kMacroBFunctions[] = {
    {"ABS", absolute},
    {"ACOS", arcCosine},
    {"ADP", [](double x) { return Outcome(x); }},
    {"ASIN",
     [](double x) {
         const Outcome angle = arcSine(x);
         return angle ? Outcome(positive(*angle)) : angle;
     }},
    {"BCD", binaryCoded},
    {"BIN", fromBinaryCoded},
    {"COS", cosine},
    {"EXP", exponential},
    {"FIX", [](double x) { return Outcome(std::trunc(x)); }},
    {"FUP", [](double x) { return Outcome(x < 0 ? std::floor(x) : std::ceil(x)); }},
    {"LN", logarithm},
    {"ROUND", nearest, true},
    {"RND", nearest, true},
    {"SIN", sine},
    {"SQRT", squareRoot},
    {"SQR", squareRoot},
    {"TAN", tangent},
};

constexpr PairFunction kMacroBPairs[] = {
    {"ATAN", [](double y, double x) { return Outcome(positive(degrees(std::atan2(y, x)))); }, true, true,
     true},
    {"POW", power, false, true, false},
};

constexpr ExpressionRules kOWordRules{kOWordOperators, kOWordFunctions, kOWordPairs, true, true, true};
constexpr ExpressionRules kLabelRules{kOWordOperators, kOWordFunctions, kOWordPairs, false};
constexpr ExpressionRules kMacroBRules{kMacroBOperators, kMacroBFunctions, kMacroBPairs, false};

} // namespace

const ExpressionRules& expressionRules(MacroLanguage language) {
    if (language == MacroLanguage::labels)
        return kLabelRules;
    return language == MacroLanguage::macroB ? kMacroBRules : kOWordRules;
}

} // namespace proveout
