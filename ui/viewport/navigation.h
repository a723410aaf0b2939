// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include <Qt>

namespace proveout {

enum class Gesture : std::uint8_t { none, orbit, pan };

/// What a drag does: one row per combination of button and modifiers.
struct NavigationRule {
    Qt::MouseButton button;
    Qt::KeyboardModifiers modifiers;
    Gesture gesture;
};
inline constexpr std::array kNavigation{
    NavigationRule{Qt::LeftButton, Qt::NoModifier, Gesture::orbit},
    NavigationRule{Qt::LeftButton, Qt::ShiftModifier, Gesture::pan},
    NavigationRule{Qt::MiddleButton, Qt::NoModifier, Gesture::pan},
};

[[nodiscard]] constexpr Gesture gestureFor(Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
    for (const NavigationRule& rule : kNavigation)
        if (rule.button == button && rule.modifiers == modifiers)
            return rule.gesture;
    return Gesture::none;
}

} // namespace proveout
