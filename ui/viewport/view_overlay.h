// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the overlay that depend on a frame.
#pragma once

#include <QPainter>
#include <QPalette>

#include "core/simulation/run/frame.h"
#include "ui/gl/scene_options.h"
#include "ui/gl/view.h"

namespace proveout {

class PartView;
class ScenePicture;

/// The data that the overlay shows.
struct OverlayContent {
    const ScenePicture& picture;
    const Frame* frame; ///< may be null
    const SceneOptions& options;
    const PartView& part;
    bool legend;
    const QPalette& palette;
};

/// Axes, legend, and notices about what the graphics driver could not draw, in `area`.
void paintOverlay(QPainter& painter, const QRect& area, const View& view, const OverlayContent& content);

} // namespace proveout
