// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/contact_view.h"

#include <algorithm>

#include <QStyle>
#include <QWidget>

namespace proveout {

ContactView::ContactView(const Session& session, Camera& camera, SceneOptions& options, QWidget& view)
    : QObject(&view), m_hub(session.contact()), m_camera(camera), m_options(options), m_view(view),
      m_flight(camera, [this] { emit moved(); }) {
    connect(&m_hub, &ContactHub::changed, this, &ContactView::show);
    connect(&session.navigation(), &NavigationHub::placeRequested, this, &ContactView::lookAt);
}

void ContactView::follow(const FramePtr& frame) {
    m_frame = frame;
    show();
}

void ContactView::show() {
    const FoundContact* contact = m_hub.in(m_frame.get());
    std::optional<ContactShown> shown;
    if (contact != nullptr)
        shown = {contact->tip, contact->part, contact->fixture};
    if (shown != m_options.contact) {
        m_options.contact = shown;
        if (shown)
            lookAt(contact->place, contact->size);
    }
    emit changed();
}

void ContactView::lookAt(const Vec3& place, double radius) {
    m_flight.start(centredOn(m_camera, place, radius), flightMilliseconds());
}

/// None if the desktop asks for no animations.
int ContactView::flightMilliseconds() const {
    constexpr int kLongest = 250;
    const int wanted = m_view.style()->styleHint(QStyle::SH_Widget_Animation_Duration, nullptr, &m_view);
    return std::clamp(wanted, 0, kLongest);
}

} // namespace proveout
