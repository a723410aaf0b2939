// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/gl/shader_program.h"

namespace proveout {

/// The shaders of the stock. Needs the context in which it was created to be current.
struct SurfacePrograms {
    /// `heights`: the file that finds the height of a point. `coloured`: by deviation (DeviationTexture).
    explicit SurfacePrograms(const char* heights, bool coloured = false);

    [[nodiscard]] bool valid() const {
        return plain.valid() && holes.valid() && wire.valid() && walls.valid();
    }

    /// This program has no hole test in its fragment shader, so hidden fragments are dropped before shading.
    ShaderProgram plain;
    ShaderProgram holes;
    ShaderProgram wire;
    ShaderProgram walls;
};

} // namespace proveout
