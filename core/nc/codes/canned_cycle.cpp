// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/codes/canned_cycle.h"

#include <algorithm>
#include <span>

#include "core/nc/codes/handlers.h"

namespace proveout {

namespace {

using enum CycleStep;

constexpr std::array<CycleStep, CannedCycle::kMostSteps> kMixedTap{
    rapidToR, mixedToBottom, reverseSpindle, dwell, mixedToClearance, restoreSpindle, startedAsLeft};

// Source: LinuxCNC's documentation of G73 to G89, in the order in which its stand-alone interpreter executes
// them.
constexpr CannedCycle kLinuxcncCycles[] = {
    {730, false, true, SpindleNeed::any, {rapidToR, peckAndBreakChip, rapidToClearance}},
    {740, false, false, SpindleNeed::counterClockwise, kMixedTap},
    {810, false, false, SpindleNeed::any, {rapidToR, feedToBottom, rapidToClearance}},
    {820, true, false, SpindleNeed::any, {rapidToR, feedToBottom, dwell, rapidToClearance}},
    {830, false, true, SpindleNeed::any, {rapidToR, peckAndRetract, rapidToClearance}},
    {840, false, false, SpindleNeed::clockwise, kMixedTap},
    {850, false, false, SpindleNeed::any, {rapidToR, feedToBottom, feedToR, rapidToClearance}},
    {860,
     true,
     false,
     SpindleNeed::turning,
     {rapidToR, feedToBottom, dwell, stopSpindle, rapidToClearance, restoreSpindle}},
    {.tenths = 870,
     .dwells = false,
     .pecks = false,
     .spindle = SpindleNeed::turning,
     .steps = {rapidToR, backBore},
     .caveat = &nc_message::kBackBore},
    {880,
     true,
     false,
     SpindleNeed::turning,
     {rapidToR, feedToBottom, dwell, stopSpindle, stopProgram, restoreSpindle, startedAsLeft}},
    {890, true, false, SpindleNeed::any, {rapidToR, feedToBottom, dwell, feedToClearance}},
};

constexpr std::array<CycleStep, CannedCycle::kMostSteps> kTapWithChuck{rapidToR, feedToBottom, reverseSpindle,
                                                                       feedToClearance, restoreSpindle};

// Where Mach differs from LinuxCNC. Source: Using Mach3Mill, canned cycles.
constexpr CannedCycle kMachCycles[] = {
    {740, false, false, SpindleNeed::counterClockwise, kTapWithChuck},
    {840, false, false, SpindleNeed::clockwise, kTapWithChuck},
    {880,
     true,
     false,
     SpindleNeed::turning,
     {rapidToR, feedToBottom, dwell, stopSpindle, stopProgram, restoreSpindle}},
};

/// Down beside the hole, up through the bore, and out again beside the hole.
constexpr std::array<CycleStep, CannedCycle::kMostSteps> kBackBoring{
    stopSpindle, shiftAside,  rapidToR,   shiftBack,        restoreSpindle, feedToBottom,
    dwell,       stopSpindle, shiftAside, rapidToClearance, shiftBack,      restoreSpindle};
constexpr std::array<CycleStep, CannedCycle::kMostSteps> kTapping{
    rapidToR, turnAsNeeded, tapToBottom, dwell, reverseSpindle, tapToR, restoreSpindle, rapidToClearance};
constexpr std::array<CycleStep, CannedCycle::kMostSteps> kManualOut{
    rapidToR, feedToBottom, dwell, stopSpindle, stopProgram, rapidToClearance, restoreSpindle};

// Source: FANUC Series 0i and 30i, operator's manuals for machining centres, canned cycles for drilling.
constexpr CannedCycle kFanucCycles[] = {
    {730, false, true, SpindleNeed::any, {rapidToR, peckAndBreakChip, rapidToClearance}},
    {740, true, true, SpindleNeed::counterClockwise, kTapping},
    {.tenths = 760,
     .dwells = true,
     .pecks = false,
     .spindle = SpindleNeed::any,
     .steps = {rapidToR, feedToBottom, dwell, stopSpindle, shiftAside, rapidToClearance, shiftBack,
               restoreSpindle},
     .shifts = true,
     .caveat = &nc_message::kFineBore},
    {810, false, false, SpindleNeed::any, {rapidToR, feedToBottom, rapidToClearance}},
    {820, true, false, SpindleNeed::any, {rapidToR, feedToBottom, dwell, rapidToClearance}},
    {830, false, true, SpindleNeed::any, {rapidToR, peckAndRetract, rapidToClearance}},
    {840, true, true, SpindleNeed::clockwise, kTapping},
    {850, false, false, SpindleNeed::any, {rapidToR, feedToBottom, feedToR, rapidToClearance}},
    {860,
     false,
     false,
     SpindleNeed::any,
     {rapidToR, feedToBottom, stopSpindle, rapidToClearance, restoreSpindle}},
    {.tenths = 870,
     .dwells = true,
     .pecks = false,
     .spindle = SpindleNeed::any,
     .steps = kBackBoring,
     .shifts = true,
     .upward = true,
     .caveat = &nc_message::kBackBore},
    {.tenths = 880,
     .dwells = true,
     .pecks = false,
     .spindle = SpindleNeed::any,
     .steps = kManualOut,
     .caveat = &nc_message::kManualExit},
    {890, true, false, SpindleNeed::any, {rapidToR, feedToBottom, dwell, feedToR, rapidToClearance}},
};

// Where Haas differs from Fanuc. Source: HAAS Mill Operator's Manual, canned cycles.
constexpr CannedCycle kHaasCycles[] = {
    {730, true, true, SpindleNeed::any, {rapidToR, peckAndBreakChip, dwell, rapidToClearance}},
    {740, false, false, SpindleNeed::counterClockwise, kTapping},
    {.tenths = 770,
     .dwells = false,
     .pecks = false,
     .spindle = SpindleNeed::any,
     .steps = kBackBoring,
     .shifts = true,
     .upward = true,
     .caveat = &nc_message::kBackBore},
    {830, true, true, SpindleNeed::any, {rapidToR, peckAndRetract, dwell, rapidToClearance}},
    {840, false, false, SpindleNeed::clockwise, kTapping},
    {.tenths = 870,
     .dwells = false,
     .pecks = false,
     .spindle = SpindleNeed::any,
     .steps = kManualOut,
     .caveat = &nc_message::kManualExit},
};

/// The cycles of a dialect: its own rows, which override those that it shares with other dialects.
struct CyclesOfDialect {
    std::span<const CannedCycle> own;
    std::span<const CannedCycle> shared;
};
constexpr std::array<CyclesOfDialect, static_cast<std::size_t>(DialectId::count)> kCycles{{
    {{}, kLinuxcncCycles},         // linuxcnc
    {{}, kFanucCycles},            // fanuc
    {kHaasCycles, kFanucCycles},   // haas
    {{}, {}},                      // grbl
    {kMachCycles, kLinuxcncCycles} // mach
}};

const CannedCycle* find(std::span<const CannedCycle> cycles, int tenths) {
    const auto found = std::ranges::find(cycles, tenths, &CannedCycle::tenths);
    return found == cycles.end() ? nullptr : &*found;
}

} // namespace

double Pecks::count(double depth) const {
    if (first <= 0 || depth <= 0)
        return 0;
    const double last = std::max(first - less, least) < first ? least : std::max(first, least);
    const double shrinking = less > 0 ? std::max(std::floor((first - last) / less), 0.0) : 0;
    // The k pecks that shrink have a total depth of k * first - less * k * (k - 1) / 2.
    const double shrunk = shrinking * first - less * shrinking * (shrinking - 1) / 2;
    if (less > 0 && shrunk >= depth) {
        const double twice = 2 * first + less;
        return std::ceil((twice - std::sqrt(std::max(twice * twice - 8 * less * depth, 0.0))) / (2 * less));
    }
    return last > 0 ? shrinking + 1 + std::ceil((depth - shrunk) / last) : shrinking + 1;
}

bool isCycle(const CodeRow* row) {
    return row != nullptr && row->handler == runCycle;
}

const CannedCycle& cycleOf(DialectId dialect, const CodeRow& row) {
    const CyclesOfDialect& cycles = kCycles[static_cast<std::size_t>(dialect)];
    const CannedCycle* own = find(cycles.own, row.tenths);
    return own != nullptr ? *own : *find(cycles.shared, row.tenths);
}

} // namespace proveout
