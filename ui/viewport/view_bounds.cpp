// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/view_bounds.h"

#include <algorithm>
#include <cmath>

#include "core/cutting/fixtures/fixture_surface.h"
#include "ui/gl/cutter_mesh.h"
#include "ui/viewport/surface_pick.h"

namespace proveout {
namespace {

constexpr double kFewestCellsShown = 4;       ///< of the grid, over the image height
constexpr double kSmallestShareOfView = 0.05; ///< of the stock in the image height
constexpr double kStepBack = 1.1;
constexpr int kMostStepsBack = 100;

} // namespace

Box3 stockBounds(const Frame& frame) {
    const StockBox& stock = frame.zmap.stock();
    Box3 box;
    box.add(Vec3(stock.corner.x, stock.corner.y, stock.floorZ()));
    box.add(Vec3(stock.corner.x + stock.width, stock.corner.y + stock.depth, stock.topZ()));
    return box;
}

Box3 workBounds(const Frame& frame, const SceneOptions& options) {
    Box3 box = stockBounds(frame);
    if (options.fixtures && frame.setup)
        for (const auto& named : frame.setup->fixtures)
            box.add(boundsOf(named.second));
    return box;
}

Box3 sceneBounds(const Frame* frame, const SceneOptions& options) {
    if (frame == nullptr)
        return {};
    Box3 box = workBounds(*frame, options);
    if (frame->program != nullptr && options.path != PathShown::none)
        box.add(frame->program->bounds());
    const Cutter* cutter =
        frame->cutterKnown && frame->setup ? frame->setup->tools.find(frame->tool) : nullptr;
    if (cutter != nullptr) {
        const Vec3& tip = options.contact ? options.contact->tip : frame->cutterPosition;
        const CutterExtent extent = cutterExtent(*cutter);
        box.add(tip - Vec3(extent.radius, extent.radius, 0));
        box.add(tip + Vec3(extent.radius, extent.radius, extent.height));
    }
    return box;
}

void limitZoom(Camera& camera, const Frame& frame, const Frame* closer) {
    const StockBox& stock = frame.zmap.stock();
    const double radius = 0.5 * std::hypot(stock.width, stock.depth, stock.height);
    const Grid& grid = closer != nullptr ? closer->zmap.grid() : frame.zmap.grid();
    const double cells = kFewestCellsShown * std::max(grid.hx, grid.hy);
    camera.limitZoom(0.5 * std::min(cells, radius), radius / kSmallestShareOfView);
}

void leaveTheSolid(Camera& camera, const Frame* frame) {
    if (frame == nullptr || !camera.perspective())
        return;
    for (int step = 0; step < kMostStepsBack && isInStock(frame->zmap, camera.eye()); ++step)
        camera.zoom(kStepBack, camera.target());
}

} // namespace proveout
