// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

namespace proveout {

/// How a scene is looked at: what a camera tells the renderer. Program coordinates, mm. Value type.
struct View {
    glm::dmat4 clipFromWorld{1};
    glm::dvec3 eye{0, 0, 1};   ///< perspective: the eye's position; else the direction towards it, unit
    glm::dvec3 right{1, 0, 0}; ///< of the screen, unit
    glm::dvec3 up{0, 1, 0};    ///< of the screen, unit
    glm::dvec3 back{0, 0, 1};  ///< from the screen towards the viewer, unit
    bool perspective = false;
    glm::ivec2 pixels{1, 1}; ///< size of the picture in device pixels
    double pixelsPerMm = 1;  ///< at the camera's target, device pixels
    double pixelRatio = 1;   ///< device pixels per pixel of the user interface
};

} // namespace proveout
