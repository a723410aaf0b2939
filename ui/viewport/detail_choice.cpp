// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/detail_choice.h"

#include <QApplication>
#include <QPainter>
#include <QPolygonF>
#include <QWidget>

#include "ui/viewport/closer_look_form.h"
#include "ui/viewport/surface_pick.h"

namespace proveout {
namespace {

constexpr int kFormMargin = 10; ///< px
constexpr double kLineWidth = 2;

/// Whether the whole box is in front of the camera's eye.
bool isInFront(const Camera& camera, const PlanBox& box, const StockBox& stock) {
    const Vec3 eye = camera.eye();
    const Vec3 forward = camera.target() - eye;
    for (const double x : {box.lo.x, box.hi.x})
        for (const double y : {box.lo.y, box.hi.y})
            for (const double z : {stock.floorZ(), stock.topZ()})
                if (glm::dot(Vec3(x, y, z) - eye, forward) <= 0)
                    return false;
    return true;
}

} // namespace

DetailChoice::DetailChoice(CloserLook& look, QWidget& view)
    : QObject(&view), m_look(look), m_view(view), m_form(new CloserLookForm(look, &view)) {
    m_form->hide();
    connect(m_form, &CloserLookForm::closed, this, &DetailChoice::closeWanted);
    connect(m_form, &CloserLookForm::edited, this, &DetailChoice::followForm);
}

void DetailChoice::open() {
    m_form->show();
    place();
}

void DetailChoice::close() {
    m_choice.reset();
    const QWidget* focus = QApplication::focusWidget();
    if (focus != nullptr && m_form->isAncestorOf(focus))
        m_view.setFocus();
    m_form->hide();
    m_look.close();
}

void DetailChoice::place() {
    m_form->move(m_view.width() - m_form->width() - kFormMargin, kFormMargin);
}

void DetailChoice::followForm() {
    const auto& box = m_look.box();
    if (!box || m_frame == nullptr)
        return;
    const Vec2 middle = (box->box.lo + box->box.hi) / 2.0;
    m_look.look({boxAbout(middle, m_form->size(), m_frame->zmap.stock()), m_form->spacing()});
}

void DetailChoice::begin(const Vec2& pixel, const Ray& ray) {
    if (const auto hit = pickStock(m_frame->zmap, ray))
        m_choice.emplace(*hit, pixel);
}

void DetailChoice::finish() {
    const BoxOfInterest box{m_choice->box(m_frame->zmap.stock(), m_form->size()), m_form->spacing()};
    m_choice.reset();
    m_look.look(box);
}

QPolygonF DetailChoice::outlineOf(const PlanBox& box, double level, const Camera& camera) const {
    QPolygonF outline;
    for (const Vec2& corner : {box.lo, Vec2(box.hi.x, box.lo.y), box.hi, Vec2(box.lo.x, box.hi.y)}) {
        const Vec2 pixel = camera.project({corner, level});
        outline << QPointF(pixel.x, pixel.y) / m_view.devicePixelRatioF();
    }
    return outline;
}

void DetailChoice::paint(QPainter& painter, const Camera& camera, const QColor& colour, bool shown) const {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colour, kLineWidth, Qt::SolidLine));
    if (m_choice)
        paintChosen(painter, camera);
    painter.setPen(QPen(colour, kLineWidth, Qt::DashLine));
    if (m_look.box() && m_look.working() && !shown)
        paintUnderWay(painter, camera);
}

void DetailChoice::paintChosen(QPainter& painter, const Camera& camera) const {
    const PlanBox box = m_choice->box(m_frame->zmap.stock(), m_form->size());
    painter.drawPolygon(outlineOf(box, m_choice->level(), camera));
}

/// Draws the box from the top of the stock to its floor.
void DetailChoice::paintUnderWay(QPainter& painter, const Camera& camera) const {
    const PlanBox& box = m_look.box()->box;
    const StockBox& stock = m_frame->zmap.stock();
    if (!isInFront(camera, box, stock))
        return;
    const QPolygonF top = outlineOf(box, stock.topZ(), camera);
    const QPolygonF floor = outlineOf(box, stock.floorZ(), camera);
    painter.drawPolygon(top);
    painter.drawPolygon(floor);
    for (int k = 0; k < top.size(); ++k)
        painter.drawLine(top[k], floor[k]);
}

} // namespace proveout
