// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "core/cutter/cutter.h"
#include "core/cutter/tool_part.h"

namespace proveout {

/// A vertex of a cutter mesh, mm from the tip.
struct CutterVertex {
    glm::vec3 position;
    glm::vec3 normal;
    float part; ///< ToolPart
};

/// The cutter's profile revolved about its axis: the fluted part up to the flute length, the shank above it,
/// and the holder where it is given, closed at the top. For a slot cutter or lollipop the flute length
/// includes the neck, which is drawn like the shank. Three vertices per triangle, counter-clockwise seen from
/// outside. The shank reaches to the holder; if there is none and no shank length is defined, it is drawn as
/// long as the flutes.
[[nodiscard]] std::vector<CutterVertex> cutterMesh(const Cutter& cutter);

/// The cylinder around cutter, shank and holder as they are drawn, mm.
struct CutterExtent {
    double radius = 0;
    double height = 0;
};
[[nodiscard]] CutterExtent cutterExtent(const Cutter& cutter);

} // namespace proveout
