// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/geometry.h"

namespace proveout {

/// From program to machine coordinates: shifted by G92 or G52, turned about Z, moved by the work offset.
struct WorkFrame {
    Vec3 offset{0};      ///< of the work offset in force
    double rotation = 0; ///< degrees about Z, of the work offset
    Vec3 shift{0};       ///< G92, G52

    [[nodiscard]] Vec3 toMachine(const Vec3& program) const;
    [[nodiscard]] Vec3 toProgram(const Vec3& machine) const;
    /// A direction of program coordinates in machine coordinates.
    [[nodiscard]] Vec3 turned(const Vec3& direction) const;

    bool operator==(const WorkFrame&) const = default;
};

} // namespace proveout
