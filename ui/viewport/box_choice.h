// SPDX-License-Identifier: GPL-3.0-or-later
// The rectangle that a user draws over the stock. Knows neither OpenGL nor widgets.
#pragma once

#include "core/zmap/grid_part.h"
#include "ui/viewport/camera.h"

namespace proveout {

inline constexpr double kDefaultBox = 10;    ///< mm along each side
inline constexpr double kLeastBoxSide = 0.1; ///< mm

/// A box of that size about a middle, moved and made smaller until it is within the stock.
[[nodiscard]] PlanBox boxAbout(const Vec2& middle, const Vec2& size, const StockBox& stock);

/// A drag from one place on the stock to another; what is less than a few pixels is a click. Value type.
class BoxChoice {
public:
    /// A place on the stock, and the pixel where it was picked.
    BoxChoice(const Vec3& place, const Vec2& pixel) : m_start(place), m_pixel(pixel), m_end(place) {}

    /// The pointer is at that pixel: on the level of the start.
    void dragTo(const Vec2& pixel, const Ray& ray);
    [[nodiscard]] double level() const { return m_start.z; }
    /// Within the stock; about the start, and of that size, where it was a click.
    [[nodiscard]] PlanBox box(const StockBox& stock, const Vec2& sizeOfClick) const;

private:
    Vec3 m_start;
    Vec2 m_pixel;
    Vec3 m_end;
    bool m_dragged = false;
};

} // namespace proveout
