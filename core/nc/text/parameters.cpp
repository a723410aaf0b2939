// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/text/parameters.h"

#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <span>

#include "core/nc/text/expression_rules.h"

namespace proveout {

namespace {

/// Numbers that programs share between their levels.
struct Range {
    int first;
    int last;
    double initial;
};

constexpr Range kOWordRanges[] = {{31, 5601, 0}};
constexpr Range kMacroBRanges[] = {
    {100, 199, kNull},
    {500, 999, kNull},
    {5201, 5340, 0},    ///< external offset, G54 to G59
    {14001, 20'000, 0}, ///< G54.1 P1 to P300
};

constexpr Range kLabelRanges[] = {{1, 10'320, 0}};

constexpr int kFirstAlias = 7001;
constexpr int kLastAlias = 7960;
constexpr int kAliasOf = 14001;

std::span<const Range> rangesOf(MacroLanguage language) {
    if (language == MacroLanguage::labels)
        return kLabelRanges;
    return language == MacroLanguage::macroB ? std::span<const Range>(kMacroBRanges)
                                             : std::span<const Range>(kOWordRanges);
}

int localsOf(MacroLanguage language) {
    if (language == MacroLanguage::labels)
        return 0;
    return language == MacroLanguage::macroB ? 33 : 30;
}

bool isGlobal(std::string_view name) {
    return name.starts_with('_');
}

/// Counts a change to a different value; null is a value.
void change(double& stored, double value, std::uint64_t& changes) {
    changes += std::bit_cast<std::uint64_t>(stored) == std::bit_cast<std::uint64_t>(value) ? 0U : 1U;
    stored = value;
}

} // namespace

Parameters::Parameters(MacroLanguage language) : m_language(language), m_levels{Level{noArguments(), {}, 0}} {
    for (const Range& range : rangesOf(language)) {
        const auto count = static_cast<std::size_t>(range.last - range.first + 1);
        m_numbered.insert(m_numbered.end(), count, range.initial);
    }
}

Parameters::Locals Parameters::noArguments() const {
    Locals locals;
    locals.fill(m_language == MacroLanguage::macroB ? kNull : 0.0);
    return locals;
}

bool Parameters::exists(int number) const {
    const bool null = number == 0 && m_language == MacroLanguage::macroB;
    return null || (number >= 1 && number <= localsOf(m_language)) || placeOf(number) < m_numbered.size();
}

std::size_t Parameters::placeOf(int number) const {
    // G54.1 P1 to P48 have two numbers each.
    if (m_language == MacroLanguage::macroB && number >= kFirstAlias && number <= kLastAlias)
        number += kAliasOf - kFirstAlias;
    std::size_t before = 0;
    for (const Range& range : rangesOf(m_language)) {
        if (number >= range.first && number <= range.last)
            return before + static_cast<std::size_t>(number - range.first);
        before += static_cast<std::size_t>(range.last - range.first + 1);
    }
    return before;
}

double Parameters::numbered(int number) const {
    if (number == 0)
        return kNull;
    if (number <= localsOf(m_language))
        return m_levels.back().numbers[static_cast<std::size_t>(number - 1)];
    const std::size_t place = placeOf(number);
    return place < m_numbered.size() ? m_numbered[place] : 0;
}

void Parameters::setNumbered(int number, double value) {
    if (number <= localsOf(m_language))
        change(m_levels.back().numbers[static_cast<std::size_t>(number - 1)], value, m_levels.back().changes);
    else if (const std::size_t place = placeOf(number); place < m_numbered.size())
        change(m_numbered[place], value, m_changes);
}

const Parameters::Names& Parameters::namesOf(std::string_view name) const {
    return isGlobal(name) ? m_globals : m_levels.back().names;
}

std::optional<double> Parameters::named(std::string_view name) const {
    const Names& names = namesOf(name);
    const auto found = names.find(name);
    return found == names.end() ? std::nullopt : std::optional(found->second);
}

bool Parameters::setNamed(std::string_view name, double value) {
    Names& names = isGlobal(name) ? m_globals : m_levels.back().names;
    std::uint64_t& changes = isGlobal(name) ? m_changes : m_levels.back().changes;
    if (const auto found = names.find(name); found != names.end()) {
        change(found->second, value, changes);
        return true;
    }
    if (m_nameCount == kMostNames)
        return false;
    ++m_nameCount;
    ++changes;
    names.emplace(name, value);
    return true;
}

std::vector<std::pair<std::string, double>> Parameters::listed() const {
    std::vector<std::pair<std::string, double>> list;
    const auto add = [&](int number, double value, double initial) {
        const bool set = std::isnan(initial) ? !std::isnan(value) : value != initial;
        if (set)
            list.emplace_back(fmt::format("#{}", number), value);
    };
    const double unset = noArguments().front();
    for (int number = 1; number <= localsOf(m_language); ++number)
        add(number, numbered(number), unset);
    auto shared = m_numbered.begin();
    for (const Range& range : rangesOf(m_language)) {
        for (int number = range.first; number <= range.last; ++number, ++shared)
            add(number, *shared, range.initial);
    }
    for (const Names* names : {&m_levels.back().names, &m_globals}) {
        for (const auto& [name, value] : *names)
            list.emplace_back(fmt::format("#<{}>", name), value);
    }
    return list;
}

void Parameters::enter(const Locals& arguments) {
    m_levels.push_back({arguments, {}, 0});
}

void Parameters::enterSharing() {
    enter(Locals(m_levels.back().numbers));
}

void Parameters::leaveSharing() {
    const Locals numbers = m_levels.back().numbers;
    const std::uint64_t changes = m_levels.back().changes;
    leave();
    m_levels.back().numbers = numbers;
    m_levels.back().changes += changes;
}

void Parameters::leave() {
    m_nameCount -= m_levels.back().names.size();
    m_levels.pop_back();
}

} // namespace proveout
