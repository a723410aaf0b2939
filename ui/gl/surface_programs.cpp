// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/surface_programs.h"

#include <utility>

namespace proveout {

namespace {

/// A program without colours does not sample the deviations, because software would do so at each pixel.
ShaderFiles top(const char* heights, bool coloured, const char* geometry, QList<const char*> defines) {
    ShaderFiles files{{heights, "walls.glsl", "surface.vert"}, geometry, {}, std::move(defines)};
    if (!files.defines.isEmpty())
        files.fragment << "cut_out.glsl";
    files.fragment << heights << "walls.glsl"
                   << "lighting.glsl";
    if (coloured) {
        files.fragment << "deviation.glsl";
        files.defines << "DEVIATION";
    }
    files.fragment << "surface.frag";
    return files;
}

} // namespace

SurfacePrograms::SurfacePrograms(const char* heights, bool coloured)
    : plain(top(heights, coloured, nullptr, {})), holes(top(heights, coloured, nullptr, {"HOLES"})),
      wire(top(heights, coloured, "wireframe.geom", {"HOLES", "WIREFRAME"})),
      walls({{heights, "walls.glsl", "surface.vert"},
             nullptr,
             {"cut_out.glsl", heights, "lighting.glsl", "wall.frag"},
             {}}) {}

} // namespace proveout
