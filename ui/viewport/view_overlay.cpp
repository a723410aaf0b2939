// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/view_overlay.h"

#include <QCoreApplication>

#include "ui/viewport/hud.h"
#include "ui/viewport/part_view.h"
#include "ui/viewport/scene_picture.h"

namespace proveout {
namespace {

/// The parts that exceed the limits of the graphics driver.
void paintOmissions(QPainter& painter, const QRect& area, const OverlayContent& content) {
    if (!content.picture.gridFits())
        paintNotice(painter, area,
                    QCoreApplication::translate("Viewport",
                                                "The grid is too large for the graphics driver; the stock is "
                                                "not drawn. Increase the grid spacing."),
                    content.palette);
    if (!content.picture.boxFits())
        paintNotice(painter, area,
                    QCoreApplication::translate("Viewport",
                                                "The detail region is too large for the graphics driver and "
                                                "is not drawn. Increase its grid spacing or make the box "
                                                "smaller."),
                    content.palette);
}

/// What the picture lacks for now, or because graphics memory or the number of triangles is limited.
QString remarkOn(const OverlayContent& content) {
    if (content.picture.isPreparing())
        return QCoreApplication::translate("Viewport", "The picture is being prepared.");
    if (content.picture.hasTooManyTriangles())
        return QCoreApplication::translate(
                   "Viewport", "The picture is coarser than the grid, because the surface has %L1 "
                               "triangles. Decimation reduces them.")
            .arg(content.frame->surface.faces);
    if (content.picture.isCoarser() && content.picture.isSoftware()) // more memory would hardly change it
        return QCoreApplication::translate("Viewport", "The picture is coarser than the grid. Zoom in.");
    if (content.picture.isCoarser())
        return QCoreApplication::translate("Viewport",
                                           "The picture is coarser than the grid. Zoom in, or allow more "
                                           "graphics memory.");
    return {};
}

} // namespace

void paintOverlay(QPainter& painter, const QRect& area, const View& view, const OverlayContent& content) {
    if (!content.picture.isUsable()) {
        painter.fillRect(area, content.palette.window());
        paintNotice(painter, area,
                    QCoreApplication::translate("Viewport", "A shader failed to compile; see the log."),
                    content.palette);
        return;
    }
    paintAxes(painter, area, view, content.palette.color(QPalette::WindowText));
    if (content.frame == nullptr)
        return;
    if (const QString remark = remarkOn(content); !remark.isEmpty())
        paintRemark(painter, area, remark, content.palette);
    paintOmissions(painter, area, content);
    const SurfaceSnapshot& surface = content.frame->surface;
    if (content.legend)
        paintLegend(painter, area, content.options,
                    {surface.faces, surface.facesFull, surface.meshes.size(), surface.dirtyRegions,
                     content.frame->setup && !content.frame->setup->fixtures.empty(),
                     content.part.part() != nullptr,
                     content.part.legend(*content.frame, content.picture.colouring())},
                    content.palette);
}

} // namespace proveout
