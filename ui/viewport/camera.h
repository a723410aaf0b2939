// SPDX-License-Identifier: GPL-3.0-or-later
// The position of the viewer. Independent of OpenGL and widgets.
#pragma once

#include <array>
#include <cstdint>

#include "core/base/geometry.h"
#include "ui/gl/view.h"

namespace proveout {

enum class StandardView : std::uint8_t { iso, top, bottom, front, back, left, right };
inline constexpr std::size_t kStandardViews = 7;

/// A ray in program coordinates; `direction` is a unit vector.
struct Ray {
    Vec3 origin{0};
    Vec3 direction{0, 0, -1};
};

/// A turntable camera with Z up: azimuth, elevation, a target, and how many mm half the image height covers
/// at the target. Equal numbers give equal apparent sizes in both projections. Image points are device pixels
/// from the upper left corner. Value type.
class Camera {
public:
    static constexpr double kFieldOfView = 0.5; ///< radians over the image height
    static constexpr double kFitMargin = 0.09;  ///< share of the image, on each side in the tighter direction

    void setPicture(int width, int height, double pixelRatio);
    void setPerspective(bool perspective) { m_perspective = perspective; }
    [[nodiscard]] bool perspective() const { return m_perspective; }
    void setStandardView(StandardView view);

    /// Azimuth and elevation of the direction from the target to the eye, radians.
    [[nodiscard]] double azimuth() const { return m_azimuth; }
    [[nodiscard]] double elevation() const { return m_elevation; }
    [[nodiscard]] const Vec3& target() const { return m_target; }
    [[nodiscard]] double halfHeight() const { return m_halfHeight; }
    [[nodiscard]] Vec3 eye() const { return m_target + back() * distance(); }

    /// Turns about the target; a drag over the full image height is half a turn.
    void orbit(double dx, double dy);
    /// Moves the camera so that points at the target's depth follow the pointer.
    void pan(double dx, double dy);
    /// The range for half the image height in mm that zoom() must respect.
    void limitZoom(double least, double most);
    /// Scales the distance to `fixed`, which keeps its position in the image; factor < 1 moves closer.
    void zoom(double factor, const Vec3& fixed);
    void setTarget(const Vec3& target) { m_target = target; }
    /// Fits the whole box into the image with kFitMargin; does nothing for an empty box.
    void fit(const Box3& box);

    [[nodiscard]] Ray ray(double x, double y) const;
    /// The point under a pixel at the target's depth.
    [[nodiscard]] Vec3 atTargetDepth(double x, double y) const;
    /// The pixel of a point in front of the eye.
    [[nodiscard]] Vec2 project(const Vec3& point) const;
    /// The view with near and far planes that just enclose `scene`.
    [[nodiscard]] View view(const Box3& scene) const;

private:
    [[nodiscard]] Vec3 right() const;
    [[nodiscard]] Vec3 up() const;
    [[nodiscard]] Vec3 back() const;
    [[nodiscard]] double distance() const;
    [[nodiscard]] double mmPerPixel() const { return 2 * m_halfHeight / m_height; }

    int m_width = 1;
    int m_height = 1;
    double m_pixelRatio = 1;
    bool m_perspective = true;
    double m_azimuth = -1.0471975511965976;
    double m_elevation = 0.6154797086703873;
    Vec3 m_target{0};
    double m_halfHeight = 100;
    double m_leastHalfHeight = 1e-3;
    double m_mostHalfHeight = 1e6;
};

} // namespace proveout
