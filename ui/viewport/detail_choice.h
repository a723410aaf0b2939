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

/// Lets the user choose a detail region in a view: by a drag or a click on the stock, then by the numbers in
/// a small form over the view. Thread: UI.
class DetailChoice final : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this object.
    DetailChoice(CloserLook& look, QWidget& view);

    /// Shows the form.
    void open();
    /// Ends the choice and closes the detail region; if the form had the focus, the view gets it.
    void close();
    /// Positions the form after the view was resized.
    void place();

    /// Starts a drag at that pixel if its ray hits the stock. There must be a frame.
    void begin(const Vec2& pixel, const Ray& ray);
    void dragTo(const Vec2& pixel, const Ray& ray) { m_choice->dragTo(pixel, ray); }
    /// Ends the drag: its box becomes the detail region.
    void finish();
    /// Whether a drag is in progress.
    [[nodiscard]] bool isDragged() const { return m_choice.has_value(); }

    /// Sets the displayed frame, in whose stock the detail region is. May be null.
    void follow(const FramePtr& frame) { m_frame = frame; }
    /// Draws the box that is dragged and, until the detail region is `shown`, the box of that region. There
    /// must be a frame.
    void paint(QPainter& painter, const Camera& camera, const QColor& colour, bool shown) const;

signals:
    /// The user has closed the form.
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
    std::optional<BoxChoice> m_choice; ///< during a drag
};

} // namespace proveout
