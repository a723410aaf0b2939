// SPDX-License-Identifier: GPL-3.0-or-later
// The rectangle that a user draws on the stock. Independent of OpenGL and widgets.
#pragma once

#include "core/zmap/grid_part.h"
#include "ui/viewport/camera.h"

namespace proveout {

inline constexpr double kDefaultBox = 10;    ///< mm, along each side
inline constexpr double kLeastBoxSide = 0.1; ///< mm, along each side

/// A box of that size around `middle`, moved and reduced until it is within the stock.
[[nodiscard]] PlanBox boxAbout(const Vec2& middle, const Vec2& size, const StockBox& stock);

/// A drag from one point on the stock to another; a drag of less than a few pixels counts as a click. Value
/// type.
class BoxChoice {
public:
    /// A point on the stock, and the pixel where it was picked.
    BoxChoice(const Vec3& place, const Vec2& pixel) : m_start(place), m_pixel(pixel), m_end(place) {}

    /// The pointer is at that pixel; its ray is intersected with the level of the start point.
    void dragTo(const Vec2& pixel, const Ray& ray);
    [[nodiscard]] double level() const { return m_start.z; }
    /// The box of the drag, within the stock; for a click, a box of the given size around the start point.
    [[nodiscard]] PlanBox box(const StockBox& stock, const Vec2& sizeOfClick) const;

private:
    Vec3 m_start;
    Vec2 m_pixel;
    Vec3 m_end;
    bool m_dragged = false;
};

} // namespace proveout
