// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/simulation/records/block_provenance.h"
#include "core/zmap/zmap.h"
#include "ui/readout/surface_probe.h"
#include "ui/viewport/camera.h"

namespace proveout {

/// The first point where a ray hits the stock: its top as the canonical full mesh, its walls or its
/// underside. Where the stock is cut away down to the floor, the ray passes through. Program coordinates.
/// Thread: any.
[[nodiscard]] std::optional<Vec3> pickStock(const ZMapSnapshot& zmap, const Ray& ray);
/// The grid point that represents a position on the surface: the nearest corner of its cell that is not above
/// it, because on a wall that is the bottom made by the cutter. Empty if all corners are above: the position
/// is on the outer side or the underside of the stock.
[[nodiscard]] std::optional<MapPoint> mapPointAt(const ZMapSnapshot& zmap, const Vec3& place);
/// The first position that a ray hits, in the view in which a detail region replaces that part of the stock;
/// `closer` and `whole` may be null.
[[nodiscard]] std::optional<SurfacePlace> pickSurface(const FramePtr& whole, const FramePtr& closer,
                                                      const Ray& ray);
/// The same without the coordinates.
[[nodiscard]] PickedPlace pickPlace(const FramePtr& whole, const FramePtr& closer, const Ray& ray);
/// Whether a point is between the stock's underside and its top, which is taken at the nearest grid point.
[[nodiscard]] bool isInStock(const ZMapSnapshot& zmap, const Vec3& point);

} // namespace proveout
