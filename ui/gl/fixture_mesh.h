// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "core/base/geometry.h"
#include "core/cutting/fixtures/fixture.h"

namespace proveout {

/// A vertex of a solid that is drawn with a colour for each of its parts.
struct SolidVertex {
    glm::vec3 position;
    glm::vec3 normal;
    float part;
};

/// Closed solids, with their position among the names as part. Three vertices per triangle, counter-clockwise
/// seen from outside; mm from `origin`, so that single precision is sufficient.
[[nodiscard]] std::vector<SolidVertex> fixtureMesh(const Fixtures& fixtures, const Vec3& origin);

} // namespace proveout
