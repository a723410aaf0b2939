// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "ui/viewport/camera.h"

namespace proveout {

inline constexpr double kLeastShown = 24; ///< logical pixels: what is smaller is enlarged …
inline constexpr double kEnlarged = 64;   ///< … to this

/// `camera` centred on a point, with the same angles; it only comes closer if something of that radius there
/// (mm) would be seen smaller than kLeastShown.
[[nodiscard]] Camera centredOn(Camera camera, const Vec3& place, double radius);

/// Moves a camera to another place and distance, until something else moves it. Thread: UI.
class CameraFlight final : public QObject {
public:
    /// `camera` must outlive this object; `moved` is called after each step.
    CameraFlight(Camera& camera, std::function<void()> moved, QObject* parent = nullptr);

    /// `milliseconds`: 0 for a jump, as the desktop asks for without animations.
    void start(const Camera& goal, int milliseconds);
    [[nodiscard]] bool isUnderWay() const { return m_tick.isActive(); }

private:
    void step();
    void move(const Vec3& target, double halfHeight);

    Camera& m_camera;
    std::function<void()> m_moved;
    Camera m_from;
    Camera m_goal;
    Camera m_left; ///< as the last step has left it
    int m_milliseconds = 0;
    QElapsedTimer m_since;
    QTimer m_tick;
};

} // namespace proveout
