// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/field_options.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <fmt/format.h>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/cli/option_error.h"
#include "core/formats/stock_shapes.h"
#include "core/nc/codes/dialects.h"
#include "core/nc/codes/ignored_codes.h"
#include "core/verification/findings/command_line_findings.h"

namespace proveout::cli {

namespace {

const std::string kAuto = "auto";

/// Converts the complete text to a number, with or without a sign; a partial match would accept "8x" as 8.
template<class Number>
std::optional<Number> numberIn(const std::string& text) {
    Number number{};
    const bool plus = text.size() > 1 && text.front() == '+' && text[1] != '-';
    const char* const end = text.data() + text.size();
    const auto [read, error] = std::from_chars(text.data() + (plus ? 1 : 0), end, number);
    return error == std::errc{} && read == end ? std::optional(number) : std::nullopt;
}

std::string withUnit(const std::string& text, const Field& field) {
    return *field.unit == '\0' ? text : fmt::format("{} {}", text, field.unit);
}

template<class Number>
CLI::Validator isNumberOf(const Field& field) {
    return CLI::Validator(
        [field](const std::string& text) -> std::string {
            const auto number = numberIn<Number>(text);
            if (number && isInRange(field, static_cast<double>(*number)))
                return {};
            return fmt::format("{} is not {} from {} to {}", text,
                               std::is_integral_v<Number> ? "a whole number" : "a number", field.minimum,
                               field.maximum);
        },
        withUnit(fmt::format("{} to {}", field.minimum, field.maximum), field));
}

/// The meaning of "auto", for use within a sentence.
std::string automaticText(const Field& field) {
    std::string text = field.automatic;
    if (!text.empty())
        text.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(text.front())));
    return kAuto + ": " + text;
}

std::vector<std::string> choiceKeys(const Field& field) {
    std::vector<std::string> keys;
    for (const Choice& choice : field.choices)
        keys.emplace_back(choice.key);
    return keys;
}

std::string flagOf(const Field& field) {
    return std::string("--") + optionOf(field);
}

} // namespace

std::set<std::string> dialectKeys() {
    std::set<std::string> keys;
    for (const Dialect& row : dialects())
        keys.emplace(row.key);
    return keys;
}

std::string OptionAdder::help(const Field& field, const std::string& defaultText) const {
    const auto other = defaultTexts.find(field.key);
    return fmt::format("{} ({})", field.help, other == defaultTexts.end() ? defaultText : other->second);
}

CLI::Option* OptionAdder::add(const Field& field, const std::string& help) const {
    const auto keep = [&given = given, key = std::string(field.key)](const std::string& text) {
        given[key] = text;
    };
    return command.add_option_function<std::string>(flagOf(field), keep, help)->group(group);
}

void OptionAdder::addFlag(const std::string& option, const char* text, const std::string& help,
                          const Field& field) const {
    const auto keep = [&given = given, key = std::string(field.key), text] { given[key] = text; };
    command.add_flag_callback(option, keep, help)->group(group);
}

void OptionAdder::addChoices(std::size_t value, const Field& field) const {
    add(field, help(field, field.choices[value].key))
        ->check(CLI::IsMember(choiceKeys(field)))
        ->type_name("M");
}

void OptionAdder::operator()(double value, const Field& field) const {
    add(field, help(field, withUnit(fmt::format("{}", value), field)))
        ->check(isNumberOf<double>(field))
        ->type_name("X");
}

void OptionAdder::operator()(int value, const Field& field) const {
    add(field, help(field, withUnit(fmt::format("{}", value), field)))
        ->check(isNumberOf<int>(field))
        ->type_name("N");
}

void OptionAdder::operator()(bool value, const Field& field) const {
    if (!field.choices.empty())
        addChoices(value ? 1 : 0, field);
    else if (value)
        addFlag(std::string("--no-") + optionOf(field), "false", fmt::format("Turn off: {}", field.help),
                field);
    else
        addFlag(flagOf(field), "true", field.help, field);
}

void OptionAdder::operator()(const std::optional<int>&, const Field& field) const {
    add(field, help(field, "unknown"))->check(isNumberOf<int>(field))->type_name("N");
}

void OptionAdder::operator()(const std::optional<Vec3>&, const Field& field) const {
    add(field, help(field, "unknown"))->type_name(withUnit("X,Y,Z", field));
}

void OptionAdder::operator()(const std::optional<DialectId>&, const Field& field) const {
    std::set<std::string> keys = dialectKeys();
    keys.insert(kAuto);
    add(field, help(field, automaticText(field)))->check(CLI::IsMember(std::move(keys)))->type_name("D");
}

void OptionAdder::operator()(const std::set<int>&, const Field& field) const {
    add(field, field.help)->type_name("N,…");
}

void OptionAdder::operator()(GridPlace<const double, const bool>, const Field& field) const {
    const auto check = [](const std::string& text) {
        return text == kAuto || numberIn<double>(text)
                   ? std::string()
                   : fmt::format("{} is neither a number of mm nor \"{}\"", text, kAuto);
    };
    add(field, help(field, automaticText(field)))
        ->check(check)
        ->type_name(withUnit("H", field) + "|" + kAuto);
}

const std::string* OptionReader::find(const Field& field) const {
    const auto found = given.find(field.key);
    return found == given.end() ? nullptr : &found->second;
}

std::size_t OptionReader::indexOf(const std::string& text, const Field& field) {
    const auto choice =
        std::ranges::find_if(field.choices, [&](const Choice& row) { return text == row.key; });
    return static_cast<std::size_t>(std::distance(field.choices.begin(), choice));
}

void OptionReader::fail(const Field& field, Diagnostics diagnostics) const {
    if (result)
        result = aboutOption(flagOf(field).c_str(), std::move(diagnostics));
}

void OptionReader::operator()(double& value, const Field& field) const {
    if (const std::string* text = find(field))
        value = numberIn<double>(*text).value_or(value);
}

void OptionReader::operator()(int& value, const Field& field) const {
    if (const std::string* text = find(field))
        value = numberIn<int>(*text).value_or(value);
}

void OptionReader::operator()(bool& value, const Field& field) const {
    if (const std::string* text = find(field))
        value = field.choices.empty() ? *text == "true" : indexOf(*text, field) == 1;
}

void OptionReader::operator()(std::optional<int>& value, const Field& field) const {
    if (const std::string* text = find(field))
        value = numberIn<int>(*text);
}

void OptionReader::operator()(std::optional<Vec3>& value, const Field& field) const {
    const std::string* text = find(field);
    if (text == nullptr)
        return;
    const auto point = parsePoint(*text);
    if (!point) {
        fail(field, point.error());
        return;
    }
    for (int axis = 0; axis < 3; ++axis) {
        if (!isInRange(field, (*point)[axis]))
            return fail(field,
                        failure(command_line_finding::kStartOutOfRange,
                                {std::string(1, "XYZ"[axis]), fmt::format("{:g}", (*point)[axis]),
                                 fmt::format("{:g}", field.minimum), fmt::format("{:g}", field.maximum)})
                            .value());
    }
    value = *point;
}

void OptionReader::operator()(std::optional<DialectId>& value, const Field& field) const {
    const std::string* text = find(field);
    if (text == nullptr)
        return;
    const Dialect* row = findDialect(*text);
    value = row == nullptr ? std::nullopt : std::optional(row->id);
}

void OptionReader::operator()(std::set<int>& value, const Field& field) const {
    const std::string* text = find(field);
    if (text == nullptr)
        return;
    auto read = parseMCodes(*text);
    if (read)
        value.merge(*read);
    else
        fail(field, std::move(read.error()));
}

void OptionReader::operator()(GridPlace<double, bool> grid, const Field& field) const {
    const std::string* text = find(field);
    if (text == nullptr)
        return;
    const auto spacing = numberIn<double>(*text);
    grid.automatic = !spacing;
    grid.spacing = spacing.value_or(grid.spacing);
}

} // namespace proveout::cli
