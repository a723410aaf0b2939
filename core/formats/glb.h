// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/base/diagnostic.h"
#include "core/base/geometry.h"
#include "core/base/triangle_mesh.h"

namespace proveout {

/// A picture that lies on a mesh as seen from above: from its lower left to its upper right corner in plan,
/// program coordinates.
struct PlanTexture {
    std::string png;
    Vec2 lo{0};
    Vec2 hi{0};
};

/// The bytes of a GLB file as writeGlb() writes it, with a picture on the mesh. Errors: those of writeGlb().
[[nodiscard]] Result<std::string> glbOf(const TriangleMesh& mesh, const PlanTexture& texture);

} // namespace proveout
