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

/// The point of the stock under the pointer: a SurfaceProbe is updated in the ticks of the session, and a
/// label next to the pointer shows the result. Thread: UI.
class PointerPlace final : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this object.
    PointerPlace(Session& session, QWidget& view);

    /// The pointer has moved to this position in view coordinates.
    void hover(const QPointF& position);
    void leave();
    /// The point under the pointer may have changed: probe() is needed with the next tick, when the status
    /// line is updated too.
    void probeAgain();
    /// Call it in a tick. The frames are those of pickSurface(). `busy`: a gesture is in progress, so the
    /// label stays hidden.
    void probe(const FramePtr& whole, const FramePtr& closer, const Camera& camera, bool busy);
    void hideLabel();

    /// Whether the user wants the label.
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
