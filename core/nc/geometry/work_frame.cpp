// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/geometry/work_frame.h"

#include <cmath>
#include <numbers>

namespace proveout {

namespace {

Vec3 turnedBy(const Vec3& v, double degrees) {
    if (degrees == 0)
        return v;
    const double angle = degrees * std::numbers::pi / 180;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {v.x * c - v.y * s, v.x * s + v.y * c, v.z};
}

} // namespace

Vec3 WorkFrame::turned(const Vec3& direction) const {
    return turnedBy(direction, rotation);
}

Vec3 WorkFrame::toMachine(const Vec3& program) const {
    const Vec3 work = transformation.any() ? transformation.apply(program) : program;
    return turnedBy(work + shift, rotation) + offset;
}

Vec3 WorkFrame::toWork(const Vec3& machine) const {
    return turnedBy(machine - offset, -rotation) - shift;
}

Vec3 WorkFrame::toProgram(const Vec3& machine) const {
    const Vec3 work = toWork(machine);
    return transformation.any() ? transformation.undo(work) : work;
}

Vec3 WorkFrame::zero() const {
    return turnedBy(shift, rotation) + offset;
}

} // namespace proveout
