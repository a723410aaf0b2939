// SPDX-License-Identifier: GPL-3.0-or-later
// What the camera is held to: the box round all that is drawn, and the limits of coming near. Program
// coordinates, mm. Thread: any.
#pragma once

#include "core/simulation/run/frame.h"
#include "ui/gl/scene_options.h"
#include "ui/viewport/camera.h"

namespace proveout {

/// The stock of a frame as it was before it was cut.
[[nodiscard]] Box3 stockBounds(const Frame& frame);
/// Stock, cutter and the toolpath that `options` show; empty where `frame` is null.
[[nodiscard]] Box3 sceneBounds(const Frame* frame, const SceneOptions& options);

/// Limits zooming to a few cells of the grid and to a small picture of the stock. `closer` is the frame of
/// the detail region that is shown, or null. The frame has a stock.
void limitZoom(Camera& camera, const Frame& frame, const Frame* closer);
/// Moves a perspective camera back until its eye is outside of the stock, whose inner sides are not drawn.
void leaveTheSolid(Camera& camera, const Frame* frame);

} // namespace proveout
