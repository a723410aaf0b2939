// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/geometry.h"
#include "ui/gl/shader_program.h"
#include "ui/gl/view.h"

namespace proveout {

/// A view in stock coordinates (mm from the stock's lower-left corner on its floor). Single precision is
/// sufficient there, wherever the stock is in program coordinates.
struct StockView {
    StockView(const View& view, const Vec3& origin);

    glm::mat4 clipFromStock;
    glm::vec4 eye;           ///< w = 1: position, 0: direction
    glm::vec3 lampDirection; ///< over the viewer's left shoulder
    glm::vec3 upOnScreen;
    glm::vec2 pixels;
    float pixelsPerMm;
    float pixelRatio;
};

/// Sets the matrix and the uniforms of lighting.glsl in the bound program.
void setView(Gl& gl, ShaderProgram& program, const StockView& view);

} // namespace proveout
