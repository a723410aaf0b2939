// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/box_choice.h"

namespace proveout {
namespace {

constexpr double kClickPixels = 6;

} // namespace

PlanBox boxAbout(const Vec2& middle, const Vec2& size, const StockBox& stock) {
    const Vec2 corner(stock.corner);
    const Vec2 fits = glm::min(size, Vec2(stock.width, stock.depth));
    const Vec2 lo = glm::clamp(middle - fits / 2.0, corner, corner + Vec2(stock.width, stock.depth) - fits);
    return {lo, lo + fits};
}

void BoxChoice::dragTo(const Vec2& pixel, const Ray& ray) {
    m_dragged = m_dragged || glm::distance(pixel, m_pixel) > kClickPixels;
    if (ray.direction.z == 0)
        return;
    const double way = (m_start.z - ray.origin.z) / ray.direction.z;
    if (way > 0)
        m_end = ray.origin + ray.direction * way;
}

PlanBox BoxChoice::box(const StockBox& stock, const Vec2& sizeOfClick) const {
    if (!m_dragged)
        return boxAbout(Vec2(m_start), sizeOfClick, stock);
    const Vec2 corner(stock.corner);
    const Vec2 far = corner + Vec2(stock.width, stock.depth);
    const Vec2 lo = glm::clamp(glm::min(Vec2(m_start), Vec2(m_end)), corner, far);
    const Vec2 hi = glm::clamp(glm::max(Vec2(m_start), Vec2(m_end)), corner, far);
    return boxAbout((lo + hi) / 2.0, glm::max(hi - lo, Vec2(kLeastBoxSide)), stock);
}

} // namespace proveout
