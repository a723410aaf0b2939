// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/setup/check_rules.h"

#include "core/base/tool_number.h"

namespace proveout {

std::optional<Field> limitField(std::string_view key) {
    std::optional<Field> found;
    RuleLimits limits;
    describe(limits, [&](double, const Field& field) {
        if (key == field.key)
            found = field;
    });
    return found;
}

std::optional<LimitOfTool> parseLimitOfTool(std::string_view text) {
    constexpr std::string_view kTool = ":T";
    const std::size_t colon = text.find(kTool);
    const std::size_t point = text.find('.', colon == std::string_view::npos ? 0 : colon);
    if (colon == std::string_view::npos || point == std::string_view::npos)
        return {};
    const std::size_t number = colon + kTool.size();
    const auto tool = parseToolNumber(text.substr(number, point - number));
    const std::string_view key = text.substr(point + 1);
    if (!tool || !limitField(key))
        return {};
    return LimitOfTool{std::string(text.substr(0, colon)), *tool, std::string(key)};
}

std::map<int, RuleLimits> CheckRules::limitsOf(std::string_view rule) const {
    std::map<int, RuleLimits> own;
    for (const auto& [name, value] : limitsOfTools) {
        const auto of = parseLimitOfTool(name);
        if (!of || of->rule != rule)
            continue;
        RuleLimits& ofTool = own.try_emplace(of->tool, limits).first->second;
        describe(ofTool, [&of = *of, value = value](double& limit, const Field& field) {
            if (of.key == field.key)
                limit = value;
        });
    }
    return own;
}

} // namespace proveout
