// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/dialect.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "core/nc/grbl_rules.h"

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
     .leastFactor = 1,
     .rotationAdds = false,
     .registersHoldDiameter = false,
     .keepsLocalShift = false,
     .allAxesGoHome = true,
     .additionalSystems = 3,
     .mostMWords = 4,
     .refusesUnused = true,
     .codeAloneMoves = true,
     .beginsInRapid = false,
     .retractsToR = true,
     .deepestCalls = 9,
     .cyclesKeepWords = false,
     .pecksShrink = false,
     .tapsRigidly = false,
     .pointMeansSeconds = true,
     .chipGapMm = 0.254,
     .peckGapMm = 0.254,
     .peckLiftMm = 0,
     .radiusWins = false,
     .arcRadiiMm = 0,
     .longestLine = 252},
    {.id = DialectId::fanuc,
     .key = "fanuc",
     .name = "Fanuc",
     .macros = MacroLanguage::macroB,
     .leastMm = 1e-3,
     .leastInch = 1e-4,
     .lastWordCounts = true,
     .leastFactor = 1e-3,
     .rotationAdds = false,
     .registersHoldDiameter = false,
     .keepsLocalShift = false,
     .allAxesGoHome = false,
     .additionalSystems = 300,
     .mostMWords = 3,
     .refusesUnused = false,
     .codeAloneMoves = false,
     .beginsInRapid = true,
     .retractsToR = false,
     .deepestCalls = 10,
     .cyclesKeepWords = true,
     .pecksShrink = false,
     .tapsRigidly = false,
     .pointMeansSeconds = false,
     .chipGapMm = 1,
     .peckGapMm = 1,
     .peckLiftMm = 0,
     .radiusWins = true,
     .arcRadiiMm = 0.02,
     .rapidAfterG80 = true},
    {.id = DialectId::haas,
     .key = "haas",
     .name = "Haas",
     .macros = MacroLanguage::macroB,
     .leastMm = 1e-3,
     .leastInch = 1e-4,
     .lastWordCounts = true,
     .leastFactor = 1,
     .rotationAdds = true,
     .registersHoldDiameter = true,
     .keepsLocalShift = true,
     .allAxesGoHome = true,
     .additionalSystems = 99,
     .mostMWords = 3,
     .refusesUnused = false,
     .codeAloneMoves = false,
     .beginsInRapid = true,
     .retractsToR = false,
     .deepestCalls = 10,
     .cyclesKeepWords = true,
     .pecksShrink = true,
     .tapsRigidly = true,
     .pointMeansSeconds = true,
     .chipGapMm = 1.27,
     .peckGapMm = 1.27,
     .peckLiftMm = 0,
     .radiusWins = true,
     .arcRadiiMm = 0.02,
     .rapidAfterG80 = true},
    // Source: grbl 1.1, its documentation and source.
    {.id = DialectId::grbl,
     .key = "grbl",
     .name = "grbl",
     .macros = MacroLanguage::none,
     .leastMm = kAsItStands,
     .leastInch = kAsItStands,
     .lastWordCounts = false,
     .leastFactor = 1,
     .rotationAdds = false,
     .registersHoldDiameter = false,
     .keepsLocalShift = false,
     .allAxesGoHome = true,
     .additionalSystems = 0,
     .mostMWords = 24,
     .refusesUnused = true,
     .codeAloneMoves = false,
     .beginsInRapid = true,
     .retractsToR = false,
     .deepestCalls = 0,
     .cyclesKeepWords = false,
     .pecksShrink = false,
     .tapsRigidly = false,
     .pointMeansSeconds = true,
     .chipGapMm = 0,
     .peckGapMm = 0,
     .peckLiftMm = 0,
     .radiusWins = false,
     .arcRadiiMm = 0,
     .arcs = ArcRule::grbl,
     .longestLine = 79,
     .largestBlockNumber = 1e7,
     .streamed = true,
     .machineIsAbsolute = true,
     .changesTools = false,
     .mayRun = mayRunOnGrbl,
     .answer = answerOfGrbl},
    // Source: Using Mach3Mill, chapter 10; Mach4 CNC Controller, Mill GCode Programming.
    {.id = DialectId::mach,
     .key = "mach",
     .name = "Mach3 / Mach4",
     .macros = MacroLanguage::labels,
     .leastMm = kAsItStands,
     .leastInch = kAsItStands,
     .lastWordCounts = false,
     .leastFactor = 1,
     .rotationAdds = false,
     .registersHoldDiameter = false,
     .keepsLocalShift = false,
     .allAxesGoHome = true,
     .additionalSystems = 248,
     .mostMWords = 4,
     .refusesUnused = true,
     .codeAloneMoves = false,
     .beginsInRapid = false,
     .retractsToR = true,
     .deepestCalls = 9,
     .cyclesKeepWords = false,
     .pecksShrink = false,
     .tapsRigidly = false,
     .pointMeansSeconds = true,
     .chipGapMm = 2.54,
     .peckGapMm = 0.254,
     .peckLiftMm = 0,
     .radiusWins = false,
     .arcRadiiMm = 0,
     .arcs = ArcRule::nist,
     .polarAboutTool = true,
     .radiusNotScaled = true,
     .dwellUnitOpen = true,
     .arcCentreOpen = true},
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
