// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "core/base/geometry.h"
#include "core/nc/program/program.h"

namespace proveout {

/// A work offset in force.
struct ActiveOffset {
    std::string code = "G54"; ///< as the program's dialect writes it: "G54.1 P3"
    Vec3 zero{0};             ///< of its coordinates, in those of the program's motions

    friend bool operator==(const ActiveOffset&, const ActiveOffset&) = default;
};

/// The one of the last motion of the first `blocks` blocks; of the first motion where `blocks` is 0. A
/// rotation of work coordinates is not in it.
[[nodiscard]] ActiveOffset activeOffset(const Program& program, std::size_t blocks);

} // namespace proveout
