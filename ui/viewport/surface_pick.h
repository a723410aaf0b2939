// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/zmap/zmap.h"
#include "ui/viewport/camera.h"

namespace proveout {

/// The first point where a ray meets the stock: its top as the canonical full mesh, its walls or its
/// underside. What is cut away to the floor is air. Program coordinates. Thread: any.
[[nodiscard]] std::optional<Vec3> pickStock(const ZMapSnapshot& zmap, const Ray& ray);
/// Whether a point lies between the stock's underside and its top, taken at the nearest grid point.
[[nodiscard]] bool isInStock(const ZMapSnapshot& zmap, const Vec3& point);

} // namespace proveout
