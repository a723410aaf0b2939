// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/surface_programs.h"

namespace proveout {

SurfacePrograms::SurfacePrograms(const char* heights)
    : plain({{heights, "surface.vert"}, nullptr, {heights, "lighting.glsl", "surface.frag"}, {}}),
      holes({{heights, "surface.vert"},
             nullptr,
             {"cut_out.glsl", heights, "lighting.glsl", "surface.frag"},
             {"HOLES"}}),
      wire({{heights, "surface.vert"},
            "wireframe.geom",
            {"cut_out.glsl", heights, "lighting.glsl", "surface.frag"},
            {"HOLES", "WIREFRAME"}}),
      walls(
          {{heights, "surface.vert"}, nullptr, {"cut_out.glsl", heights, "lighting.glsl", "wall.frag"}, {}}) {
}

} // namespace proveout
