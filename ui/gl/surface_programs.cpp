// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/surface_programs.h"

namespace proveout {

SurfacePrograms::SurfacePrograms(const char* heights)
    : plain({{heights, "walls.glsl", "surface.vert"},
             nullptr,
             {heights, "walls.glsl", "lighting.glsl", "surface.frag"},
             {}}),
      holes({{heights, "walls.glsl", "surface.vert"},
             nullptr,
             {"cut_out.glsl", heights, "walls.glsl", "lighting.glsl", "surface.frag"},
             {"HOLES"}}),
      wire({{heights, "walls.glsl", "surface.vert"},
            "wireframe.geom",
            {"cut_out.glsl", heights, "walls.glsl", "lighting.glsl", "surface.frag"},
            {"HOLES", "WIREFRAME"}}),
      walls({{heights, "walls.glsl", "surface.vert"},
             nullptr,
             {"cut_out.glsl", heights, "lighting.glsl", "wall.frag"},
             {}}) {}

} // namespace proveout
