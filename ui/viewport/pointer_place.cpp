// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/pointer_place.h"

#include <QApplication>
#include <QWidget>

#include "ui/readout/probe_text.h"
#include "ui/readout/surface_probe.h"
#include "ui/session/session.h"
#include "ui/viewport/place_label.h"
#include "ui/viewport/surface_pick.h"

namespace proveout {

PointerPlace::PointerPlace(Session& session, QWidget& view)
    : QObject(&view), m_session(session), m_view(view), m_probe(new SurfaceProbe(this)),
      m_label(new PlaceLabel(&view)) {
    connect(m_probe, &SurfaceProbe::answered, &session.playback(), &PlaybackHub::requestTick);
}

void PointerPlace::hover(const QPointF& position) {
    m_hover = position;
    probeAgain();
}

void PointerPlace::leave() {
    m_label->hide();
    probeAgain();
    m_hover.reset();
}

void PointerPlace::probeAgain() {
    if (m_hover)
        m_session.playback().requestTick();
}

void PointerPlace::probe(const FramePtr& whole, const FramePtr& closer, const Camera& camera, bool busy) {
    std::optional<SurfacePlace> place;
    if (m_hover) {
        const QPointF pixel = *m_hover * m_view.devicePixelRatioF();
        place = pickSurface(whole, closer, camera.ray(pixel.x(), pixel.y()));
    }
    if (place || m_probe->place())
        m_probe->point(place, whole != nullptr && whole->program == m_session.program().current());
    showLabel(busy);
}

void PointerPlace::showLabel(bool busy) {
    const bool covered = busy || QApplication::activePopupWidget() != nullptr;
    if (!m_labelShown || !m_hover || !m_probe->place() || covered || !m_view.isActiveWindow())
        return m_label->hide();
    QStringList lines{positionText(*m_probe, m_view.locale()),
                      deviationText(*m_probe, m_session.part().comparison().get(), m_view.locale()),
                      cutText(*m_probe)};
    lines.removeAll(QString());
    m_label->showAt(m_view.mapToGlobal(m_hover->toPoint()), lines.join(u'\n'));
}

void PointerPlace::hideLabel() {
    m_label->hide();
}

void PointerPlace::setLabelShown(bool shown) {
    m_labelShown = shown;
    probeAgain();
}

} // namespace proveout
