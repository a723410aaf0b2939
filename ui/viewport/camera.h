// SPDX-License-Identifier: GPL-3.0-or-later
// Where the viewer stands. Knows neither OpenGL nor widgets.
#pragma once

#include <array>
#include <cstdint>

#include "core/base/geometry.h"
#include "ui/gl/view.h"

namespace proveout {

enum class StandardView : std::uint8_t { iso, top, bottom, front, back, left, right };
inline constexpr std::size_t kStandardViews = 7;

/// A ray in program coordinates; `direction` is unit.
struct Ray {
    Vec3 origin{0};
    Vec3 direction{0, 0, -1};
};

/// A turntable with Z up: azimuth, elevation, a target, and how many mm half the picture's height shows at
/// the target. The same numbers mean the same apparent size in both projections. Points of the picture are
/// device pixels from its upper left corner. Value type.
class Camera {
public:
    static constexpr double kFieldOfView = 0.5; ///< radians over the picture's height
    static constexpr double kFitMargin = 0.09;  ///< of the picture, on each side of the tighter direction

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

    /// Turns about the target; a drag across the picture's height is half a turn.
    void orbit(double dx, double dy);
    /// Moves so that what lies at the target's depth follows the pointer.
    void pan(double dx, double dy);
    /// How many mm half the picture's height may show after zoom().
    void limitZoom(double least, double most);
    /// Scales the distance to `fixed`, which keeps its place in the picture; factor < 1 comes nearer.
    void zoom(double factor, const Vec3& fixed);
    void setTarget(const Vec3& target) { m_target = target; }
    /// The whole box inside the picture with kFitMargin; nothing for an empty box.
    void fit(const Box3& box);

    [[nodiscard]] Ray ray(double x, double y) const;
    /// The point under a pixel at the target's depth.
    [[nodiscard]] Vec3 atTargetDepth(double x, double y) const;
    /// Pixel of a point that lies in front of the eye.
    [[nodiscard]] Vec2 project(const Vec3& point) const;
    /// With near and far planes just around `scene`.
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
