// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QObject>

#include "ui/viewport/box_choice.h"
#include "ui/viewport/closer_look.h"

class QColor;
class QPainter;
class QWidget;

namespace proveout {

class CloserLookForm;

/// How the user chooses a detail region in a view: by a drag or a click on the stock, then by the numbers of
/// a small form over the view. Thread: UI.
class DetailChoice final : public QObject {
    Q_OBJECT

public:
    /// Both outlive this object.
    DetailChoice(CloserLook& look, QWidget& view);

    /// Shows the form.
    void open();
    /// Ends the choice and the detail region; the view has the focus if the form had it.
    void close();
    /// The view has another size.
    void place();

    /// A drag begins at that pixel, if its ray meets the stock. There is a frame.
    void begin(const Vec2& pixel, const Ray& ray);
    void dragTo(const Vec2& pixel, const Ray& ray) { m_choice->dragTo(pixel, ray); }
    /// The drag ends: its box is the detail region.
    void finish();
    /// A drag is under way.
    [[nodiscard]] bool isDragged() const { return m_choice.has_value(); }

    /// What is shown; the detail region lies in its stock. May be null.
    void follow(const FramePtr& frame) { m_frame = frame; }
    /// The box that is dragged and, until the detail region is `shown`, where it will be. There is a frame.
    void paint(QPainter& painter, const Camera& camera, const QColor& colour, bool shown) const;

signals:
    /// The user closes the form.
    void closeWanted();

private:
    void followForm();
    [[nodiscard]] QPolygonF outlineOf(const PlanBox& box, double level, const Camera& camera) const;
    void paintChosen(QPainter& painter, const Camera& camera) const;
    void paintUnderWay(QPainter& painter, const Camera& camera) const;

    CloserLook& m_look;
    QWidget& m_view;
    CloserLookForm* m_form;
    FramePtr m_frame;
    std::optional<BoxChoice> m_choice; ///< while it is dragged
};

} // namespace proveout
