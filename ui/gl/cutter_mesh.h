// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "core/cutter/cutter.h"

namespace proveout {

/// A vertex of a drawn cutter, mm from its tip.
struct CutterVertex {
    glm::vec3 position;
    glm::vec3 normal;
    float part; ///< 0: fluted, 1: shank
};

/// The cutter's profile revolved about its axis: fluted part to the flute length, shank above it, closed at
/// the top. Of a necked head the neck is as long as the flutes are said to be, and drawn as the shank is.
/// Three vertices a triangle, counter-clockwise seen from outside. Without a shank length one is drawn as
/// long as the flutes.
[[nodiscard]] std::vector<CutterVertex> cutterMesh(const Cutter& cutter);

} // namespace proveout
