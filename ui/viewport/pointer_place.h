// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QObject>
#include <QPointF>

#include "core/simulation/run/frame.h"
#include "ui/viewport/camera.h"

class QWidget;

namespace proveout {

class PlaceLabel;
class Session;
class SurfaceProbe;

/// The point of the stock under the pointer: a SurfaceProbe follows it in the ticks of the session, and a
/// label beside the pointer shows it. Thread: UI.
class PointerPlace final : public QObject {
    Q_OBJECT

public:
    /// Both outlive this object.
    PointerPlace(Session& session, QWidget& view);

    /// The pointer is there, in the coordinates of the view.
    void hover(const QPointF& position);
    void leave();
    /// Another point of the stock may be under the pointer: probe() is due with the next tick, as the status
    /// line shows it too.
    void probeAgain();
    /// In a tick. The frames are those of pickSurface(). `busy`: a gesture is under way, so that the label is
    /// in its way.
    void probe(const FramePtr& whole, const FramePtr& closer, const Camera& camera, bool busy);
    void hideLabel();

    /// Whether the label is shown at all.
    [[nodiscard]] bool labelShown() const { return m_labelShown; }
    void setLabelShown(bool shown);

private:
    void showLabel(bool busy);

    Session& m_session;
    QWidget& m_view;
    std::optional<QPointF> m_hover; ///< the pointer, while it is over the view
    SurfaceProbe* m_probe;
    PlaceLabel* m_label;
    bool m_labelShown = true;
};

} // namespace proveout
