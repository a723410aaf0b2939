// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/camera_flight.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace proveout {

namespace {

constexpr int kStepMs = 16;

} // namespace

Camera centredOn(Camera camera, const Vec3& place, double radius) {
    camera.setTarget(place);
    const View view = camera.view({});
    const double shown = 2 * radius * view.pixelsPerMm / view.pixelRatio;
    if (shown > 0 && shown < kLeastShown)
        camera.zoom(shown / kEnlarged, place);
    return camera;
}

CameraFlight::CameraFlight(Camera& camera, std::function<void()> moved, QObject* parent)
    : QObject(parent), m_camera(camera), m_moved(std::move(moved)) {
    m_tick.setInterval(kStepMs);
    connect(&m_tick, &QTimer::timeout, this, &CameraFlight::step);
}

void CameraFlight::start(const Camera& goal, int milliseconds) {
    m_from = m_left = m_camera;
    m_goal = goal;
    m_milliseconds = milliseconds;
    m_since.start();
    m_tick.start();
    step();
}

void CameraFlight::move(const Vec3& target, double halfHeight) {
    m_camera.setTarget(target);
    m_camera.zoom(halfHeight / m_camera.halfHeight(), target);
}

void CameraFlight::step() {
    if (m_camera.target() != m_left.target() || m_camera.halfHeight() != m_left.halfHeight())
        return m_tick.stop();
    const double share =
        m_milliseconds > 0 ? std::min(1.0, static_cast<double>(m_since.elapsed()) / m_milliseconds) : 1;
    if (share < 1) {
        const double eased = share * share * (3 - 2 * share);
        move(m_from.target() + (m_goal.target() - m_from.target()) * eased,
             m_from.halfHeight() * std::pow(m_goal.halfHeight() / m_from.halfHeight(), eased));
    } else {
        m_tick.stop();
        move(m_goal.target(), m_goal.halfHeight());
    }
    m_moved(); // may step back from the stock
    m_left = m_camera;
}

} // namespace proveout
