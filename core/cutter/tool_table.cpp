// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cutter/tool_table.h"

#include <algorithm>

namespace proveout {

const char* name(ToolSource source) {
    switch (source) {
    case ToolSource::given:
        return "given";
    case ToolSource::comment:
        return "comment";
    case ToolSource::assumed:
        return "assumed";
    }
    return "";
}

bool ToolOrigin::states(const std::string& key) const {
    const auto isIn = [&](const std::vector<std::string>& keys) {
        return std::find(keys.begin(), keys.end(), key) != keys.end();
    };
    return isIn(entered) || (source != ToolSource::assumed && !isIn(defaults));
}

void ToolTable::set(int number, Cutter cutter, ToolOrigin origin) {
    m_tools.insert_or_assign(number, std::move(cutter));
    if (origin.source == ToolSource::given)
        m_unconfirmed.erase(number);
    else
        m_unconfirmed.insert_or_assign(number, std::move(origin));
}

void ToolTable::remove(int number) {
    m_tools.erase(number);
    m_unconfirmed.erase(number);
}

} // namespace proveout
