// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "core/base/geometry.h"
#include "core/nc/program/program.h"

namespace proveout {

/// An active work offset.
struct ActiveOffset {
    std::string code = "G54"; ///< as the program's dialect writes it: "G54.1 P3"
    Vec3 zero{0};             ///< zero of its coordinates, in those of the program's motions

    friend bool operator==(const ActiveOffset&, const ActiveOffset&) = default;
};

/// The one at the last motion of the first `blocks` blocks; at the first motion if `blocks` is 0. It does not
/// include a rotation of work coordinates.
[[nodiscard]] ActiveOffset activeOffset(const Program& program, std::size_t blocks);

} // namespace proveout
