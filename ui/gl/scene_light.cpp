// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/gl/scene_light.h"

#include <glm/gtc/matrix_transform.hpp>

namespace proveout {

StockView::StockView(const View& view, const Vec3& origin)
    : clipFromStock(view.clipFromWorld * glm::translate(glm::dmat4(1), origin)),
      eye(view.perspective ? glm::vec4(view.eye - origin, 1) : glm::vec4(view.eye, 0)),
      // Half fixed to the viewer, half to the world: turning the stock moves the light over it, but no side
      // is ever completely dark.
      lampDirection(
          glm::normalize(-0.55 * view.right + 0.45 * view.up + 0.85 * view.back + glm::dvec3(0, 0, 0.35))),
      upOnScreen(view.up), pixels(view.pixels), pixelsPerMm(static_cast<float>(view.pixelsPerMm)),
      pixelRatio(static_cast<float>(view.pixelRatio)) {}

void setView(Gl& gl, ShaderProgram& program, const StockView& view) {
    program.set(gl, "clipFromStock", view.clipFromStock);
    program.set(gl, "eye", view.eye);
    program.set(gl, "lampDirection", view.lampDirection);
    program.set(gl, "upOnScreen", view.upOnScreen);
    program.set(gl, "viewportSize", view.pixels);
}

} // namespace proveout
