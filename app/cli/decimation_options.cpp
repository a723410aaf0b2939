// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/decimation_options.h"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <iterator>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/decimation/regions/region_decimator.h"

namespace proveout::cli {

namespace {

template<class Value>
void set(Value& target, const std::string& text, const Field& field) {
    if constexpr (std::is_enum_v<Value>) {
        const auto choice =
            std::ranges::find_if(field.choices, [&](const Choice& row) { return text == row.key; });
        target = static_cast<Value>(std::distance(field.choices.begin(), choice));
    } else if constexpr (std::is_same_v<Value, bool>) {
        target = text == "true";
    } else {
        std::from_chars(text.data(), text.data() + text.size(), target);
    }
}

std::vector<std::string> keys(const Field& field) {
    std::vector<std::string> out;
    for (const Choice& choice : field.choices)
        out.emplace_back(choice.key);
    return out;
}

/// The whole text is a number of the field's type and range; without this, "8x" would pass as 8.
template<class Value>
CLI::Validator numberOf(const Field& field) {
    return CLI::Validator(
        [minimum = field.minimum, maximum = field.maximum](const std::string& text) -> std::string {
            Value value{};
            const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
            const bool inRange =
                static_cast<double>(value) >= minimum && static_cast<double>(value) <= maximum;
            if (error == std::errc{} && end == text.data() + text.size() && inRange)
                return {};
            return fmt::format("{} is not {} from {} to {}", text,
                               std::is_integral_v<Value> ? "a whole number" : "a number", minimum, maximum);
        },
        fmt::format("{} to {}", field.minimum, field.maximum));
}

/// "8", or what differs by method: "20; global: 1".
std::string standardOf(int DecimationMethodRow::*number) {
    const int first = decimationMethods().front().*number;
    std::string text = std::to_string(first);
    for (const DecimationMethodRow& method : decimationMethods())
        if (method.*number != first)
            text += fmt::format("; {}: {}", kMethodChoices[static_cast<std::size_t>(method.method)].key,
                                method.*number);
    return text;
}

/// What holds where the option is not given.
template<class Value>
std::string standardText(const Value& value, const Field& field) {
    if (std::string_view(field.key) == "region")
        return fmt::format("{}; doubled up to {} if a map would have more than {} regions",
                           standardOf(&DecimationMethodRow::standardRegion), kLargestStandardRegion,
                           kMostStandardRegions);
    if (std::string_view(field.key) == "period")
        return standardOf(&DecimationMethodRow::standardPeriod);
    if constexpr (std::is_enum_v<Value>)
        return field.choices[static_cast<std::size_t>(value)].key;
    else
        return fmt::format("{}{}{}", value, *field.unit == '\0' ? "" : " ", field.unit);
}

} // namespace

void DecimationOptions::addTo(CLI::App& command) {
    const DecimationParameters standard;
    describe(standard, [&](const auto& value, const Field& field) {
        using Value = std::remove_cvref_t<decltype(value)>;
        const std::string key = field.key;
        const auto keep = [this, key](const std::string& text) { m_given[key] = text; };
        CLI::Option* option = nullptr;
        if constexpr (std::is_same_v<Value, bool>) {
            const std::string help = fmt::format("Turn off: {}", field.help);
            option = command.add_flag_callback(
                "--no-" + key, [keep] { keep("false"); }, help);
        } else {
            const std::string help = fmt::format("{} ({})", field.help, standardText(value, field));
            option = command.add_option_function<std::string>("--" + key, keep, help);
            if constexpr (std::is_enum_v<Value>)
                option->check(CLI::IsMember(keys(field)))->type_name("M");
            else
                option->check(numberOf<Value>(field))->type_name(std::is_integral_v<Value> ? "N" : "X");
        }
        option->group("Decimation");
    });
}

void DecimationOptions::apply(DecimationParameters& parameters, Named named, double points) const {
    const DecimationMethod before = parameters.method;
    describe(parameters, [this](auto& value, const Field& field) {
        if (const auto found = m_given.find(field.key); found != m_given.end())
            set(value, found->second, field);
    });
    const bool sameMethod = parameters.method == before;
    useStandards(parameters, given("region") || (named.region && sameMethod),
                 given("period") || (named.period && sameMethod), points);
}

} // namespace proveout::cli
