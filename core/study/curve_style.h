// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/study/chart.h"

namespace proveout {

/// Colours that colour-blind readers can distinguish (Okabe and Ito), each with its own dash and marker.
struct CurveStyle {
    const char* colour;
    const char* dash;
    int corners; ///< of the marker; 0: a disc
};
inline constexpr std::array kCurveStyles{
    CurveStyle{"#0072b2", "none", 0},       CurveStyle{"#d55e00", "8 3", 4},  CurveStyle{"#009e73", "3 3", 3},
    CurveStyle{"#aa4499", "10 3 3 3", 5},   CurveStyle{"#b8860b", "14 4", 6}, CurveStyle{"#444444", "2 4", 4},
    CurveStyle{"#56b4e9", "6 2 2 2 2 2", 3}};

[[nodiscard]] inline const CurveStyle& style(const Curve& curve) {
    return kCurveStyles[static_cast<std::size_t>(std::max(0, curve.colour)) % kCurveStyles.size()];
}

/// As a value of stroke-dasharray.
[[nodiscard]] inline const char* dashOf(const Curve& curve) {
    if (curve.look == CurveLook::level)
        return "2 3";
    return curve.look == CurveLook::marked ? style(curve).dash : "none";
}

} // namespace proveout
