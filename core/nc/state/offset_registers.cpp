// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/state/offset_registers.h"

#include <span>

namespace proveout {

namespace {

using Entry = OffsetRegisters::Entry;

/// System variables that name the same entry of successive numbers, from 1 on.
struct Variables {
    int first;
    int last;
    Entry entry;
};

constexpr Variables kFanuc[] = {
    {2001, 2200, Entry::lengthWear}, {2201, 2400, Entry::length},       {10001, 10999, Entry::lengthWear},
    {11001, 11999, Entry::length},   {12001, 12999, Entry::radiusWear}, {13001, 13999, Entry::radius},
};
constexpr Variables kHaas[] = {
    {2001, 2200, Entry::length},
    {2201, 2400, Entry::lengthWear},
    {2401, 2600, Entry::radius},
    {2601, 2800, Entry::radiusWear},
};

} // namespace

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

std::optional<OffsetRegisters::Place> OffsetRegisters::place(DialectId dialect, int variable) {
    for (const Variables& row : dialect == DialectId::haas ? std::span<const Variables>(kHaas)
                                                           : std::span<const Variables>(kFanuc)) {
        if (variable >= row.first && variable <= row.last)
            return Place{row.entry, variable - row.first + 1};
    }
    return {};
}

} // namespace proveout
