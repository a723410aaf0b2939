// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/canned_cycle.h"

#include <algorithm>

namespace proveout {

namespace {

using enum CycleStep;

// By number.
constexpr CannedCycle kCycles[] = {
    {730, false, true, SpindleNeed::any, {peckAndBreakChip, rapidToClearance}},
    {740,
     false,
     false,
     SpindleNeed::counterClockwise,
     {feedToBottom, reverseSpindle, dwell, feedToClearance, restoreSpindle}},
    {810, false, false, SpindleNeed::any, {feedToBottom, rapidToClearance}},
    {820, true, false, SpindleNeed::any, {feedToBottom, dwell, rapidToClearance}},
    {830, false, true, SpindleNeed::any, {peckAndRetract, rapidToClearance}},
    {840,
     false,
     false,
     SpindleNeed::clockwise,
     {feedToBottom, reverseSpindle, dwell, feedToClearance, restoreSpindle}},
    {850, false, false, SpindleNeed::any, {feedToBottom, feedToR, rapidToClearance}},
    {860,
     true,
     false,
     SpindleNeed::turning,
     {feedToBottom, dwell, stopSpindle, rapidToClearance, restoreSpindle}},
    {870, false, false, SpindleNeed::turning, {backBore}},
    {880, true, false, SpindleNeed::turning, {feedToBottom, dwell, stopSpindle, stopProgram, restoreSpindle}},
    {890, true, false, SpindleNeed::any, {feedToBottom, dwell, feedToClearance}},
};

} // namespace

const CannedCycle* findCycle(const CodeRow* row) {
    if (row == nullptr || row->letter != 'G')
        return nullptr;
    const auto* cycle = std::ranges::find(kCycles, row->tenths, &CannedCycle::tenths);
    return cycle == std::end(kCycles) ? nullptr : cycle;
}

} // namespace proveout
