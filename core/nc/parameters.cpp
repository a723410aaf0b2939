// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/parameters.h"

namespace proveout {

namespace {

bool isGlobal(std::string_view name) {
    return name.starts_with('_');
}

} // namespace

Parameters::Parameters() : m_numbered(kMost, 0.0), m_levels(1) {}

double Parameters::numbered(int number) const {
    if (number <= kLocals)
        return m_levels.back().numbers[static_cast<std::size_t>(number - 1)];
    return m_numbered[static_cast<std::size_t>(number)];
}

void Parameters::setNumbered(int number, double value) {
    if (number <= kLocals)
        m_levels.back().numbers[static_cast<std::size_t>(number - 1)] = value;
    else
        m_numbered[static_cast<std::size_t>(number)] = value;
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
    if (const auto found = names.find(name); found != names.end()) {
        found->second = value;
        return true;
    }
    if (m_nameCount == kMostNames)
        return false;
    ++m_nameCount;
    names.emplace(name, value);
    return true;
}

void Parameters::enter(const Locals& arguments) {
    m_levels.push_back({arguments, {}});
}

void Parameters::leave() {
    m_nameCount -= m_levels.back().names.size();
    m_levels.pop_back();
}

} // namespace proveout
