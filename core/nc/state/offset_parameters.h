// SPDX-License-Identifier: GPL-3.0-or-later
// Where LinuxCNC stores offsets and reference positions among the parameters: X, Y and Z are consecutive.
#pragma once

#include "core/base/geometry.h"
#include "core/nc/text/parameters.h"

namespace proveout {

inline constexpr int kHomeParameter = 5161;       ///< G28
inline constexpr int kSecondHomeParameter = 5181; ///< G30
inline constexpr int kShiftOnParameter = 5210;    ///< 1 while G92, G52 or G92.3 is in force
inline constexpr int kShiftParameter = 5211;      ///< G92
inline constexpr int kFirstOffsetParameter = 5221;
inline constexpr int kParametersPerOffset = 20;
inline constexpr int kRotationParameter = 9; ///< within those of one offset
inline constexpr int kOffsetCount = 9;       ///< G54 to G59.3

/// X of work offset `system`, 1 for G54.
[[nodiscard]] constexpr int offsetParameter(int system) {
    return kFirstOffsetParameter + kParametersPerOffset * (system - 1);
}

[[nodiscard]] inline Vec3 vectorAt(const Parameters& parameters, int first) {
    return {parameters.numbered(first), parameters.numbered(first + 1), parameters.numbered(first + 2)};
}

inline void setVectorAt(Parameters& parameters, int first, const Vec3& value) {
    for (int axis = 0; axis < 3; ++axis)
        parameters.setNumbered(first + axis, value[axis]);
}

} // namespace proveout
