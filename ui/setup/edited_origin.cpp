// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/setup/edited_origin.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace proveout {

namespace {

template<class Value>
void addChanges(const std::map<std::string, Value>& before, const std::map<std::string, Value>& after,
                std::set<std::string>& changed) {
    for (const auto& [key, value] : after)
        if (const auto found = before.find(key); found != before.end() && found->second != value)
            changed.insert(key);
}

/// The keys that only the new shape has count as defaults, because they were not entered.
void useShape(ToolOrigin& origin, const ToolSpec& before, const ToolSpec& after) {
    std::erase_if(origin.defaults, [&](const std::string& key) { return !after.values.contains(key); });
    for (const auto& row : after.values)
        if (!before.values.contains(row.first))
            origin.defaults.push_back(row.first);
}

} // namespace

std::optional<ToolOrigin> editedOrigin(ToolOrigin origin, const ToolSpec& before, const ToolSpec& after) {
    std::set<std::string> changed;
    if (before.shape == after.shape) {
        addChanges(before.values, after.values, changed);
        addChanges(before.texts, after.texts, changed);
        if (changed.contains("d") || changed.contains("p"))
            return std::nullopt;
    } else {
        changed.insert("shape");
        if (origin.source == ToolSource::comment)
            useShape(origin, before, after);
    }
    for (const std::string& key : changed) {
        std::erase(origin.defaults, key);
        if (std::ranges::find(origin.entered, key) == origin.entered.end())
            origin.entered.push_back(key);
    }
    return origin;
}

} // namespace proveout
