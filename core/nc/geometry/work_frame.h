// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/base/geometry.h"
#include "core/nc/geometry/transformation.h"
#include "core/nc/program/motion.h"

namespace proveout {

/// Converts program to machine coordinates: transformed by the program, shifted by G92 or G52, rotated about
/// Z, moved by the work offset. Only LinuxCNC rotates work offsets, only Fanuc's dialect has transformations.
struct WorkFrame {
    Vec3 offset{0};      ///< of the work offset in force
    double rotation = 0; ///< degrees about Z, of the work offset
    Vec3 shift{0};       ///< G92, G52
    Transformation transformation;

    [[nodiscard]] Vec3 toMachine(const Vec3& program) const;
    [[nodiscard]] Vec3 toProgram(const Vec3& machine) const;
    /// Work coordinates: without the transformations of the program.
    [[nodiscard]] Vec3 toWork(const Vec3& machine) const;
    /// The work zero in machine coordinates.
    [[nodiscard]] Vec3 zero() const;
    /// A direction of program coordinates, converted to machine coordinates.
    [[nodiscard]] Vec3 turned(const Vec3& direction) const;
    /// AxisBits of the machine's axes that depend on more than one program axis.
    [[nodiscard]] std::uint8_t mixedAxes() const {
        return rotation != 0 ? std::uint8_t{kAxisX | kAxisY} : transformation.mixedAxes();
    }

    bool operator==(const WorkFrame&) const = default;
};

} // namespace proveout
