// SPDX-License-Identifier: GPL-3.0-or-later
// How drags, the wheel and keys move a camera. Points are pixels of its picture.
#pragma once

#include <QPointF>

#include "ui/viewport/camera.h"
#include "ui/viewport/navigation.h"

class QKeyEvent;

namespace proveout {

/// A drag of the mouse that turns or moves a camera, as the rows of kNavigation say. Value type.
class CameraDrag {
public:
    void begin(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, const QPointF& pixel);
    /// False where the drag is none of a camera.
    bool dragTo(const QPointF& pixel, Camera& camera);
    void end() { m_gesture = Gesture::none; }
    [[nodiscard]] bool isUnderWay() const { return m_gesture != Gesture::none; }

private:
    Gesture m_gesture = Gesture::none;
    QPointF m_last;
};

/// By a turn of the wheel, in units of QWheelEvent; the point `fixed` keeps its place in the picture.
void zoomByWheel(Camera& camera, int angle, const Vec3& fixed);
/// Alt and an arrow turn it; false for every other key.
bool turnByKey(Camera& camera, const QKeyEvent& event);

} // namespace proveout
