// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

namespace proveout {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kSmallestHalfHeight = 1e-3;

struct Angles {
    double azimuth;
    double elevation;
};
// Same order as StandardView. The isometric view is from the right, front and above.
constexpr std::array<Angles, kStandardViews> kAngles{{
    {-kPi / 4, 0.6154797086703873}, // atan(1 / sqrt 2)
    {-kPi / 2, kPi / 2},
    {-kPi / 2, -kPi / 2},
    {-kPi / 2, 0},
    {kPi / 2, 0},
    {kPi, 0},
    {0, 0},
}};

std::array<Vec3, 8> corners(const Box3& box) {
    std::array<Vec3, 8> points;
    for (std::size_t k = 0; k < points.size(); ++k)
        points[k] = {(k & 1) != 0 ? box.hi.x : box.lo.x, (k & 2) != 0 ? box.hi.y : box.lo.y,
                     (k & 4) != 0 ? box.hi.z : box.lo.z};
    return points;
}

} // namespace

void Camera::setPicture(int width, int height, double pixelRatio) {
    m_width = std::max(width, 1);
    m_height = std::max(height, 1);
    m_pixelRatio = pixelRatio;
}

void Camera::setStandardView(StandardView view) {
    const Angles& angles = kAngles[static_cast<std::size_t>(view)];
    m_azimuth = angles.azimuth;
    m_elevation = angles.elevation;
}

Vec3 Camera::right() const {
    return {-std::sin(m_azimuth), std::cos(m_azimuth), 0};
}

Vec3 Camera::up() const {
    return {-std::sin(m_elevation) * std::cos(m_azimuth), -std::sin(m_elevation) * std::sin(m_azimuth),
            std::cos(m_elevation)};
}

Vec3 Camera::back() const {
    return {std::cos(m_elevation) * std::cos(m_azimuth), std::cos(m_elevation) * std::sin(m_azimuth),
            std::sin(m_elevation)};
}

double Camera::distance() const {
    return m_halfHeight / std::tan(kFieldOfView / 2);
}

void Camera::orbit(double dx, double dy) {
    const double perPixel = kPi / m_height;
    m_azimuth = std::remainder(m_azimuth - dx * perPixel, 2 * kPi);
    m_elevation = std::clamp(m_elevation + dy * perPixel, -kPi / 2, kPi / 2);
}

void Camera::pan(double dx, double dy) {
    m_target += (right() * -dx + up() * dy) * mmPerPixel();
}

void Camera::limitZoom(double least, double most) {
    m_leastHalfHeight = std::max(least, kSmallestHalfHeight);
    m_mostHalfHeight = std::max(most, m_leastHalfHeight);
}

void Camera::zoom(double factor, const Vec3& fixed) {
    const double wanted = std::clamp(m_halfHeight * factor, m_leastHalfHeight, m_mostHalfHeight);
    factor = wanted / m_halfHeight;
    m_halfHeight = wanted;
    // Scales target and eye about the fixed point, so the direction from the eye to it stays the same.
    m_target = fixed + (m_target - fixed) * factor;
}

void Camera::fit(const Box3& box) {
    if (box.empty())
        return;
    // Screen coordinates of the corners relative to the centre of the box; b points towards the viewer.
    const Vec3 centre = 0.5 * (box.lo + box.hi);
    const double room = 1 - 2 * kFitMargin;
    const double aspect = static_cast<double>(m_width) / m_height;
    const double tangent = std::tan(kFieldOfView / 2);
    // Per axis: the eye's depth D and offset t with |x - t| <= k (D - b) for every corner; without
    // perspective the depth has no effect and D becomes half the height.
    const auto least = [&](const Vec3& axis, double k) {
        double high = -1e300;
        double low = -1e300;
        const double slope = m_perspective ? k : 0;
        for (const Vec3& corner : corners(box)) {
            const Vec3 at = corner - centre;
            high = std::max(high, glm::dot(at, axis) + slope * glm::dot(at, back()));
            low = std::max(low, -glm::dot(at, axis) + slope * glm::dot(at, back()));
        }
        return std::pair{(high + low) / (2 * k), (high - low) / 2};
    };
    const double scale = m_perspective ? tangent : 1;
    const auto [depthX, placeX] = least(right(), scale * aspect * room);
    const auto [depthY, placeY] = least(up(), scale * room);
    const double depth = std::max({depthX, depthY, kSmallestHalfHeight});
    m_halfHeight = m_perspective ? depth * tangent : depth;
    m_target = centre + right() * placeX + up() * placeY;
}

Ray Camera::ray(double x, double y) const {
    const Vec3 point = atTargetDepth(x, y);
    if (!m_perspective)
        return {point + back() * distance(), -back()};
    return {eye(), glm::normalize(point - eye())};
}

Vec3 Camera::atTargetDepth(double x, double y) const {
    return m_target + (right() * (x - 0.5 * m_width) + up() * (0.5 * m_height - y)) * mmPerPixel();
}

Vec2 Camera::project(const Vec3& point) const {
    const Vec3 at = point - m_target;
    const double shrink = m_perspective ? distance() / (distance() - glm::dot(at, back())) : 1;
    return {0.5 * m_width + glm::dot(at, right()) * shrink / mmPerPixel(),
            0.5 * m_height - glm::dot(at, up()) * shrink / mmPerPixel()};
}

View Camera::view(const Box3& scene) const {
    double nearest = -distance();
    double farthest = distance();
    if (!scene.empty()) {
        nearest = 1e300;
        farthest = -1e300;
        for (const Vec3& corner : corners(scene)) {
            const double depth = distance() - glm::dot(corner - m_target, back());
            nearest = std::min(nearest, depth);
            farthest = std::max(farthest, depth);
        }
    }
    const double slack = 0.01 * std::max(farthest - nearest, 1.0);
    farthest += slack;
    nearest -= slack;
    const double aspect = static_cast<double>(m_width) / m_height;
    View view;
    if (m_perspective) {
        farthest = std::max(farthest, 1e-3);
        nearest = std::max(nearest, farthest * 1e-4); // required by a 24 bit depth buffer
        view.clipFromWorld = glm::perspective(kFieldOfView, aspect, nearest, farthest);
        view.eye = eye();
    } else {
        view.clipFromWorld = glm::ortho(-m_halfHeight * aspect, m_halfHeight * aspect, -m_halfHeight,
                                        m_halfHeight, nearest, farthest);
        view.eye = back();
    }
    view.clipFromWorld = view.clipFromWorld * glm::lookAt(eye(), m_target, up());
    view.right = right();
    view.up = up();
    view.back = back();
    view.perspective = m_perspective;
    view.pixels = {m_width, m_height};
    view.pixelsPerMm = 1 / mmPerPixel();
    view.pixelRatio = m_pixelRatio;
    return view;
}

} // namespace proveout
