// SPDX-License-Identifier: GPL-3.0-or-later
// The overlay of the 3D view: axes, legend, notices. Painted in paintGL, because every other repaint in a
// window with a QOpenGLWidget composes the whole window again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <QLocale>
#include <QPainter>
#include <QPalette>
#include <QString>

#include "core/part/part_spec.h"
#include "ui/gl/scene_options.h"
#include "ui/gl/view.h"

namespace proveout {

/// What the legend says about the colours of deviations.
struct DeviationLegend {
    PartTolerance tolerance;
    QString note; ///< what the colours lack; empty: nothing
};

/// Its lines: what is measured, and the bands from excess to gouge; a band without width is left out.
struct DeviationLines {
    enum class Band : std::uint8_t { excess, left, missing, gouge };
    QString title;
    std::vector<std::pair<Band, QString>> bands;
};
[[nodiscard]] DeviationLines linesOf(const DeviationLegend& legend, const QLocale& locale);

/// The figures of a frame that the legend shows.
struct LegendFigures {
    std::size_t faces = 0;
    std::size_t facesFull = 0;
    std::size_t regions = 0;
    std::size_t dirtyRegions = 0;
    bool fixtures = false; ///< there are some
    bool part = false;     ///< it is drawn
    std::optional<DeviationLegend> deviation = {};
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
