// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "core/simulation/run/frame.h"
#include "ui/gl/scene_options.h"
#include "ui/session/session.h"
#include "ui/viewport/camera_flight.h"

class QWidget;

namespace proveout {

/// Shows the tool in the moment of the chosen contact, and brings its place into view once the stock is that
/// of its block. Thread: UI.
class ContactView final : public QObject {
    Q_OBJECT

public:
    /// All must outlive this object; it sets `options.contact`, and moves the camera.
    ContactView(const Session& session, Camera& camera, SceneOptions& options, QWidget& view);

    /// The frame in the view; may be null.
    void follow(const FramePtr& frame);

    /// Brings a place into view, and what is around it within a radius, mm.
    void lookAt(const Vec3& place, double radius);

signals:
    /// The camera has moved.
    void moved();
    /// Another contact, or none.
    void changed();

private:
    void show();
    [[nodiscard]] int flightMilliseconds() const;

    const ContactHub& m_hub;
    Camera& m_camera;
    SceneOptions& m_options;
    QWidget& m_view;
    FramePtr m_frame;
    CameraFlight m_flight;
};

} // namespace proveout
