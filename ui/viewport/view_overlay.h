// SPDX-License-Identifier: GPL-3.0-or-later
// What of a frame is written over its picture.
#pragma once

#include <QPainter>
#include <QPalette>

#include "core/simulation/run/frame.h"
#include "ui/gl/scene_options.h"
#include "ui/gl/view.h"

namespace proveout {

class ScenePicture;

/// What the overlay is about.
struct OverlayContent {
    const ScenePicture& picture;
    const Frame* frame; ///< may be null
    const SceneOptions& options;
    bool legend;
    const QPalette& palette;
};

/// Axes, legend, and notices of what the graphics driver could not draw, in `area`.
void paintOverlay(QPainter& painter, const QRect& area, const View& view, const OverlayContent& content);

} // namespace proveout
