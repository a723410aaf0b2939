// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/flow/haas_variables.h"

#include "core/nc/flow/number_ranges.h"

namespace proveout {

namespace {

constexpr NumberRange kMonitors[] = {
    {1064, 1068}, ///< largest axis loads
    {1264, 1268}, ///< the same, of further axes
    {1601, 1800}, ///< flutes of the tools
    {1801, 2000}, ///< vibrations of the tools
    {3020, 3025}, ///< timers of the machine and of the cycle
    {3028, 3028}, ///< pallet
    {3030, 3033}, ///< single block, dry run, block delete, optional stop
    {3201, 3600}, ///< actual diameters of the tools, positions of the coolant nozzle
    {5401, 5500}, ///< tool feed timers
    {5501, 5600}, ///< total tool timers
    {5601, 5800}, ///< tool life: limits, counters
    {5801, 6000}, ///< tool loads: maxima, limits
    {7501, 7506}, ///< pallets: priority
    {7601, 7606}, ///< status
    {7701, 7706}, ///< programs
    {7801, 7806}, ///< uses
    {8500, 8515}, ///< tool groups
    {8550, 8564}, ///< a tool by its ID
    {9000, 9015}, ///< thermal compensation
};

constexpr NumberRange kSettings[] = {
    {1080, 1087},   ///< analog inputs, raw
    {1090, 1098},   ///< and filtered
    {6001, 6277},   ///< settings
    {6501, 6999},   ///< parameters
    {11000, 11063}, ///< inputs
    {13000, 13013}, ///< analog inputs, filtered
};

/// Variables with two numbers: the first and last number of a range, and the other number of `first`.
struct Alias {
    NumberRange numbers;
    int legacy;
};
constexpr Alias kAliases[] = {
    {{10100, 10199}, 100},
    {{10500, 10699}, 500},
    {{10800, 10999}, 800},
};

} // namespace

bool isMonitorOfHaas(int number) {
    return anyContains(kMonitors, number);
}

bool isSettingOfHaas(int number) {
    return anyContains(kSettings, number);
}

std::optional<int> legacyNumberOfHaas(int number) {
    for (const Alias& row : kAliases) {
        if (row.numbers.contains(number))
            return row.legacy + number - row.numbers.first;
    }
    return {};
}

} // namespace proveout
