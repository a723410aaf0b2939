// SPDX-License-Identifier: GPL-3.0-or-later
// The overlay of the 3D view: axes, legend, notices. Painted in paintGL, because every other repaint in a
// window with a QOpenGLWidget composes the whole window again.
#pragma once

#include <cstddef>

#include <QPainter>
#include <QPalette>
#include <QString>

#include "ui/gl/scene_options.h"
#include "ui/gl/view.h"

namespace proveout {

/// The figures of a frame that the legend shows.
struct LegendFigures {
    std::size_t faces = 0;
    std::size_t facesFull = 0;
    std::size_t regions = 0;
    std::size_t dirtyRegions = 0;
    bool fixtures = false; ///< there are some
};

/// The three axes as arrows with letters in the lower left corner of `area`.
void paintAxes(QPainter& painter, const QRect& area, const View& view, const QColor& text);

/// The legend for everything that `options` enable, in the upper left corner of `area`.
void paintLegend(QPainter& painter, const QRect& area, const SceneOptions& options,
                 const LegendFigures& figures, const QPalette& palette);

/// A message in the lower right corner of `area`, about a picture that is usable all the same.
void paintRemark(QPainter& painter, const QRect& area, const QString& text, const QPalette& palette);

/// A message in the middle of `area`.
void paintNotice(QPainter& painter, const QRect& area, const QString& text, const QPalette& palette);

} // namespace proveout
