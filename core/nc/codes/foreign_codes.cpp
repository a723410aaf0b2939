// SPDX-License-Identifier: GPL-3.0-or-later
// A code that is known but not supported has a name, and a rule for the axis words of its block.
#include "core/nc/codes/code_rows.h"

#include "core/base/text.h"
#include "core/nc/codes/handlers.h"

namespace proveout {

namespace {

// clang-format off
constexpr CodeRow kForeign[] = {
    {'G', 90, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "exact stop in one block")},
    {'G', 120, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "clockwise circular pocket"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 130, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "counter-clockwise circular pocket"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 150, ModalGroup::polar, PROVEOUT_TEXT("Core", "polar coordinates off")},
    {'G', 160, ModalGroup::polar, PROVEOUT_TEXT("Core", "polar coordinates on"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 310, ModalGroup::nonModal, PROVEOUT_TEXT("Core", "skip motion (probe)"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 440, ModalGroup::toolLength, PROVEOUT_TEXT("Core", "negative tool length offset")},
    {'G', 500, ModalGroup::scaling, PROVEOUT_TEXT("Core", "scaling off")},
    {'G', 501, ModalGroup::mirroring, PROVEOUT_TEXT("Core", "mirroring off"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 510, ModalGroup::scaling, PROVEOUT_TEXT("Core", "scaling"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 511, ModalGroup::mirroring, PROVEOUT_TEXT("Core", "mirroring"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 541, ModalGroup::workOffset, PROVEOUT_TEXT("Core", "additional work offset")},
    {'G', 650, ModalGroup::macroCall, PROVEOUT_TEXT("Core", "macro call"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 660, ModalGroup::macroCall, PROVEOUT_TEXT("Core", "modal macro call"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 670, ModalGroup::macroCall, PROVEOUT_TEXT("Core", "modal macro call off")},
    {'G', 680, ModalGroup::rotation, PROVEOUT_TEXT("Core", "coordinate rotation"), nullptr, Step::none, {}, AxisUse::takes},
    {'G', 690, ModalGroup::rotation, PROVEOUT_TEXT("Core", "coordinate rotation off")},
    {'M', 290, ModalGroup::spindle, PROVEOUT_TEXT("Core", "rigid tapping")},
    {'M', 970, ModalGroup::subprogram, PROVEOUT_TEXT("Core", "local subprogram call")},
};
// clang-format on

} // namespace

std::span<const CodeRow> foreignCodes() {
    return kForeign;
}

} // namespace proveout
