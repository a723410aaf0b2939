// SPDX-License-Identifier: GPL-3.0-or-later
// Limits of the camera: the bounding box of everything that is drawn, and the zoom limits. Program
// coordinates, mm. Thread: any.
#pragma once

#include "core/simulation/run/frame.h"
#include "ui/gl/scene_options.h"
#include "ui/viewport/camera.h"

namespace proveout {

/// The uncut stock of a frame.
[[nodiscard]] Box3 stockBounds(const Frame& frame);
/// What is fitted into the view: the stock, and the fixtures if `options` show them.
[[nodiscard]] Box3 workBounds(const Frame& frame, const SceneOptions& options);
/// The same, the cutter, and the toolpath if `options` show it; empty if `frame` is null.
[[nodiscard]] Box3 sceneBounds(const Frame* frame, const SceneOptions& options);

/// Limits zooming in to a few cells of the grid, and zooming out to a minimum size of the stock. `closer` is
/// the frame of the detail region that is shown, or null. The frame must have a stock.
void limitZoom(Camera& camera, const Frame& frame, const Frame* closer);
/// Moves a perspective camera back until its eye is outside the stock, because the inside is not drawn.
void leaveTheSolid(Camera& camera, const Frame* frame);

} // namespace proveout
