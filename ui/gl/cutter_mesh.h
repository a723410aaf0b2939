// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "core/cutter/cutter.h"

namespace proveout {

/// A vertex of a cutter mesh, mm from the tip.
struct CutterVertex {
    glm::vec3 position;
    glm::vec3 normal;
    float part; ///< 0: fluted, 1: shank
};

/// The cutter's profile revolved about its axis: the fluted part up to the flute length, the shank above it,
/// closed at the top. For a slot cutter or lollipop the flute length includes the neck, which is drawn like
/// the shank. Three vertices per triangle, counter-clockwise seen from outside. If no shank length is
/// defined, the shank is drawn as long as the flutes.
[[nodiscard]] std::vector<CutterVertex> cutterMesh(const Cutter& cutter);

} // namespace proveout
