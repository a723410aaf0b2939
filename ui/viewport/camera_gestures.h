// SPDX-License-Identifier: GPL-3.0-or-later
// How drags, the wheel and keys move a camera. Points are pixels of its image.
#pragma once

#include <QPointF>

#include "ui/viewport/camera.h"
#include "ui/viewport/navigation.h"

class QKeyEvent;

namespace proveout {

/// A mouse drag that orbits or pans a camera, according to the rows of kNavigation. Value type.
class CameraDrag {
public:
    void begin(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, const QPointF& pixel);
    /// False if the drag does not move the camera.
    bool dragTo(const QPointF& pixel, Camera& camera);
    void end() { m_gesture = Gesture::none; }
    [[nodiscard]] bool isUnderWay() const { return m_gesture != Gesture::none; }

private:
    Gesture m_gesture = Gesture::none;
    QPointF m_last;
};

/// `angle` is the wheel angle in units of QWheelEvent; the point `fixed` keeps its position in the image.
void zoomByWheel(Camera& camera, int angle, const Vec3& fixed);
/// Alt and an arrow key orbit the camera; false for every other key.
bool turnByKey(Camera& camera, const QKeyEvent& event);

} // namespace proveout
