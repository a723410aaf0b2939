// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/state/offset_registers.h"

namespace proveout {

const std::optional<double>* OffsetRegisters::written(Entry entry, int number) const {
    const auto found = m_written.find(number);
    if (found == m_written.end())
        return nullptr;
    const std::optional<double>& value = found->second[static_cast<std::size_t>(entry)];
    return value ? &value : nullptr;
}

std::optional<double> OffsetRegisters::value(Entry entry, int number) const {
    if (number == 0)
        return 0;
    if (const auto* value = written(entry, number))
        return *value;
    if (entry == Entry::lengthWear || entry == Entry::radiusWear)
        return 0;
    const ToolOffset* tool = m_tools.find(number);
    if (tool == nullptr)
        return {};
    return entry == Entry::length ? tool->offset.z : m_diameters ? tool->diameter : tool->diameter / 2;
}

void OffsetRegisters::set(Entry entry, int number, double value) {
    m_written[number][static_cast<std::size_t>(entry)] = value;
}

std::optional<double> OffsetRegisters::length(int number) const {
    const auto geometry = value(Entry::length, number);
    return geometry ? std::optional(*geometry + *value(Entry::lengthWear, number)) : std::nullopt;
}

std::optional<double> OffsetRegisters::radius(int number) const {
    const auto geometry = value(Entry::radius, number);
    if (!geometry)
        return {};
    const double sum = *geometry + *value(Entry::radiusWear, number);
    return m_diameters ? sum / 2 : sum;
}

bool OffsetRegisters::certain(Entry entry, int number) const {
    return number == 0 || written(entry, number) != nullptr ||
           (m_tools.given() && m_tools.find(number) != nullptr);
}

bool OffsetRegisters::assumedRadius(int number) const {
    if (number == 0 || written(Entry::radius, number) != nullptr)
        return false;
    const ToolOffset* tool = m_tools.find(number);
    return tool != nullptr && tool->assumed;
}

std::optional<OffsetRegisters::Place> OffsetRegisters::place(const Dialect& dialect, int variable) {
    for (const RegisterVariables& row : dialect.registerVariables) {
        if (variable >= row.first && variable <= row.last)
            return Place{row.entry, variable - row.first + 1};
    }
    return {};
}

} // namespace proveout
