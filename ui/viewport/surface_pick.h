// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/simulation/records/block_provenance.h"
#include "core/zmap/zmap.h"
#include "ui/readout/surface_probe.h"
#include "ui/viewport/camera.h"

namespace proveout {

/// The first point where a ray meets the stock: its top as the canonical full mesh, its walls or its
/// underside. What is cut away to the floor is air. Program coordinates. Thread: any.
[[nodiscard]] std::optional<Vec3> pickStock(const ZMapSnapshot& zmap, const Ray& ray);
/// The point of the grid that stands for a place of the surface: of the corners of its cell that do not lie
/// above it the nearest, for on a wall it is the foot that a cutter has made. Nothing where all do: there is
/// the outer side or the underside of the stock.
[[nodiscard]] std::optional<MapPoint> mapPointAt(const ZMapSnapshot& zmap, const Vec3& place);
/// The place that a ray meets first, in the picture that shows a closer look in the place of the stock there;
/// `closer` may be null, as `whole` may.
[[nodiscard]] std::optional<SurfacePlace> pickSurface(const FramePtr& whole, const FramePtr& closer,
                                                      const Ray& ray);
/// The same, without where it is.
[[nodiscard]] PickedPlace pickPlace(const FramePtr& whole, const FramePtr& closer, const Ray& ray);
/// Whether a point lies between the stock's underside and its top, taken at the nearest grid point.
[[nodiscard]] bool isInStock(const ZMapSnapshot& zmap, const Vec3& point);

} // namespace proveout
