// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/dialect.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace proveout {

namespace {

constexpr double kAsItStands = 1;

constexpr Dialect kDialects[] = {
    {.id = DialectId::linuxcnc,
     .key = "linuxcnc",
     .name = "LinuxCNC",
     .macros = MacroLanguage::oWords,
     .leastMm = kAsItStands,
     .leastInch = kAsItStands,
     .lastWordCounts = false,
     .mostMWords = 4,
     .refusesUnused = true,
     .codeAloneMoves = true,
     .beginsInRapid = false,
     .retractsToR = true,
     .deepestCalls = 9},
    {.id = DialectId::fanuc,
     .key = "fanuc",
     .name = "Fanuc",
     .macros = MacroLanguage::macroB,
     .leastMm = 1e-3,
     .leastInch = 1e-4,
     .lastWordCounts = true,
     .mostMWords = 3,
     .refusesUnused = false,
     .codeAloneMoves = false,
     .beginsInRapid = true,
     .retractsToR = false,
     .deepestCalls = 10},
    {.id = DialectId::haas,
     .key = "haas",
     .name = "Haas",
     .macros = MacroLanguage::macroB,
     .leastMm = 1e-3,
     .leastInch = 1e-4,
     .lastWordCounts = true,
     .mostMWords = 3,
     .refusesUnused = false,
     .codeAloneMoves = false,
     .beginsInRapid = true,
     .retractsToR = false,
     .deepestCalls = 10},
};
static_assert(std::size(kDialects) == static_cast<std::size_t>(DialectId::count));

} // namespace

std::span<const Dialect> dialects() {
    return kDialects;
}

const Dialect& dialect(DialectId id) {
    return kDialects[static_cast<std::size_t>(id)];
}

const Dialect* findDialect(std::string_view key) {
    const auto* row =
        std::ranges::find(kDialects, key, [](const Dialect& one) { return std::string_view(one.key); });
    return row == std::end(kDialects) ? nullptr : row;
}

} // namespace proveout
