// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/check_settings.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <vector>

#include "app/cli/option_error.h"
#include "core/base/field.h"
#include "core/base/tool_number.h"
#include "core/verification/findings/command_line_findings.h"
#include "core/verification/findings/findings.h"
#include "core/verification/verdict/not_checked.h"

namespace proveout::cli {

namespace {

using namespace command_line_finding;

std::vector<std::string> itemsOf(const std::string& list) {
    std::vector<std::string> items;
    for (std::size_t begin = 0; begin < list.size();) {
        const std::size_t end = std::min(list.find(',', begin), list.size());
        if (end > begin)
            items.push_back(list.substr(begin, end - begin));
        begin = end + 1;
    }
    return items;
}

Result<void> setLimit(const std::string& key, const std::string& text, RuleLimits& limits) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool number = error == std::errc() && end == text.data() + text.size();
    bool known = false;
    bool fits = true;
    describe(limits, [&](double& field, const Field& of) {
        if (key != of.key)
            return;
        known = true;
        fits = number && isInRange(of, value);
        if (fits)
            field = value;
    });
    if (!known)
        return failure(kRuleKeyUnknown, {key});
    return fits ? Result<void>() : failure(kRuleValueBad, {text, key});
}

/// `ID=off`, `ID:T3=off`, `ID:key=value` or `ID:T3.key=value`
Result<void> setRule(const std::string& item, CheckRules& rules) {
    const std::size_t equals = item.find('=');
    const std::size_t colon = item.find(':');
    const std::string id = item.substr(0, std::min(equals, colon));
    if (equals == std::string::npos)
        return failure(kRuleForm, {item});
    if (findFinding(id) == nullptr)
        return failure(kRuleUnknown, {id});
    const std::string value = item.substr(equals + 1);
    const std::string key = colon < equals ? item.substr(colon + 1, equals - colon - 1) : std::string();
    if (const std::string name = item.substr(0, equals); parseLimitOfTool(name)) {
        RuleLimits scratch;
        if (auto set = setLimit(key.substr(key.find('.') + 1), value, scratch); !set)
            return set;
        std::from_chars(value.data(), value.data() + value.size(), rules.limitsOfTools[name]);
        return {};
    }
    const auto tool = key.starts_with('T') ? parseToolNumber(key.substr(1)) : std::nullopt;
    if (!key.empty() && !tool)
        return setLimit(key, value, rules.limits);
    if (value != "off")
        return failure(kRuleForm, {item});
    rules.off.insert({tool ? ruleForTool(id, *tool) : id, {}});
    return {};
}

} // namespace

void CheckSettings::addTo(CLI::App& command) {
    command
        .add_option("--rules", m_rules,
                    "Rules that are off, for all tools or one, and limits: "
                    "air-cutting=off,full-slot:T3=off,table-collision:belowStock=5,"
                    "table-collision:T3.belowStock=1; ids: proveout-cli rules")
        ->type_name("ID=off|ID:T…=off|ID:key=value|ID:T….key=value,…");
    command.add_option("--accept", m_accepted, "What need not be checked, by the ids under \"not checked\"")
        ->type_name("ID,…");
}

Result<void> CheckSettings::apply(CheckRules& rules) const {
    for (const std::string& item : itemsOf(m_rules))
        if (auto set = setRule(item, rules); !set)
            return aboutOption("--rules", std::move(set.error()));
    for (const std::string& id : itemsOf(m_accepted)) {
        const auto isIt = [&](const NotCheckedRow& row) { return id == row.id; };
        if (std::ranges::none_of(notCheckedRows(), isIt))
            return aboutOption("--accept", failure(kAcceptUnknown, {id}).value());
        rules.accepted.insert({id, {}});
    }
    return {};
}

void CheckSettings::note(const CLI::App& command) {
    constexpr std::array<std::string_view, 8> kWithoutEffect{"INPUT",  "--json",   "--sarif",   "--junit",
                                                             "--jobs", "--resume", "--threads", "--help"};
    m_text.clear();
    for (const CLI::Option* option : command.get_options()) {
        if (std::ranges::find(kWithoutEffect, std::string_view(option->get_name())) != kWithoutEffect.end())
            continue;
        for (const std::string& value : option->results())
            m_text += option->get_name() + '=' + value + '\n';
    }
}

} // namespace proveout::cli
