// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/camera_gestures.h"

#include <cmath>
#include <utility>

#include <QKeyEvent>
#include <QWheelEvent>

namespace proveout {
namespace {

constexpr double kZoomPerStep = 0.85; ///< per wheel step, which is an angle of 120 units
constexpr double kKeyOrbitPixels = 40;

} // namespace

void CameraDrag::begin(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, const QPointF& pixel) {
    m_gesture = gestureFor(button, modifiers);
    m_last = pixel;
}

bool CameraDrag::dragTo(const QPointF& pixel, Camera& camera) {
    if (!isUnderWay())
        return false;
    const QPointF drag = pixel - std::exchange(m_last, pixel);
    if (m_gesture == Gesture::orbit)
        camera.orbit(drag.x(), drag.y());
    else
        camera.pan(drag.x(), drag.y());
    return true;
}

void zoomByWheel(Camera& camera, int angle, const Vec3& fixed) {
    camera.zoom(std::pow(kZoomPerStep, angle / double{QWheelEvent::DefaultDeltasPerStep}), fixed);
}

bool turnByKey(Camera& camera, const QKeyEvent& event) {
    const double dx = (event.key() == Qt::Key_Right) - (event.key() == Qt::Key_Left);
    const double dy = (event.key() == Qt::Key_Down) - (event.key() == Qt::Key_Up);
    if ((event.modifiers() & Qt::AltModifier) == 0 || (dx == 0 && dy == 0))
        return false;
    camera.orbit(dx * kKeyOrbitPixels, dy * kKeyOrbitPixels);
    return true;
}

} // namespace proveout
