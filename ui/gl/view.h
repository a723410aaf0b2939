// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

namespace proveout {

/// The view of a scene, as a camera passes it to the renderer. Program coordinates, mm. Value type.
struct View {
    glm::dmat4 clipFromWorld{1};
    glm::dvec3 eye{0, 0, 1};   ///< perspective: position of the eye; otherwise the unit vector towards it
    glm::dvec3 right{1, 0, 0}; ///< of the screen, unit vector
    glm::dvec3 up{0, 1, 0};    ///< of the screen, unit vector
    glm::dvec3 back{0, 0, 1};  ///< from the screen towards the viewer, unit vector
    bool perspective = false;
    glm::ivec2 pixels{1, 1}; ///< size of the image in device pixels
    double pixelsPerMm = 1;  ///< device pixels per mm at the camera's target
    double pixelRatio = 1;   ///< device pixels per logical pixel
};

} // namespace proveout
