// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/viewport.h"

#include <cmath>

#include <QOpenGLPaintDevice>
#include <QPainter>

#include "ui/look/theme.h"
#include "ui/viewport/contact_view.h"
#include "ui/viewport/detail_choice.h"
#include "ui/viewport/foreign_notice.h"
#include "ui/viewport/part_view.h"
#include "ui/viewport/pointer_place.h"
#include "ui/viewport/tool_notice.h"
#include "ui/viewport/view_bounds.h"
#include "ui/viewport/view_overlay.h"
#include "ui/viewport/viewport_commands.h"

namespace proveout {
namespace {

QSurfaceFormat formatFor(const GlSupport& support) {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    // In software, four samples per pixel triple the cost of an image, so only images at rest are antialiased
    // there.
    format.setSamples(support.software ? 0 : 4);
    return format;
}

} // namespace

Viewport::Viewport(Session& session, const GlSupport& support, QWidget* parent)
    : QOpenGLWidget(parent), m_session(session), m_detail(new DetailChoice(m_look, *this)),
      m_place(new PointerPlace(session, *this)), m_part(new PartView(session, m_options, this)),
      m_picture(std::make_unique<ScenePicture>(*this, m_look, m_options, support.software)),
      m_contact(new ContactView(session, m_camera, m_options, *this)) {
    setFormat(formatFor(support));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(160, 120);

    m_commands = addCommands(*this);
    setAccessibleName(tr("3D view"));
    connect(m_detail, &DetailChoice::closeWanted, this, &Viewport::closeLook);
    connect(&m_look, &CloserLook::changed, this, &Viewport::followLook);
    connect(m_picture.get(), &ScenePicture::partUploaded, &session.playback(), &PlaybackHub::reportUploading);
    connect(&session.playback(), &PlaybackHub::tick, this, &Viewport::onTick);
    connect(m_contact, &ContactView::changed, this, &Viewport::followOptions);
    m_picture->setPart(m_part);
    connect(m_part, &PartView::changed, this, &Viewport::followOptions);
    connect(m_part, &PartView::changed, m_place, &PointerPlace::probeAgain);
    connect(m_contact, &ContactView::moved, this, &Viewport::moved);
    new ToolNotice(session, this);
    new ForeignNotice(session, this);
    followPalette();
    followOptions();
    setFrame(session.simulation().frame());
}

Viewport::~Viewport() = default;

void Viewport::onTick(const FramePtr& frame) {
    setFrame(frame);
    m_place->probe(m_frame, m_look.picture(), m_camera, m_drag.isUnderWay() || m_detail->isDragged());
}

void Viewport::setFrame(const FramePtr& frame) {
    if (frame == m_frame)
        return;
    m_frame = frame;
    if (looksCloser() && (frame == nullptr || frame->zmap.stock() != m_fittedStock))
        closeLook(); // a region of another stock is meaningless
    m_look.follow(frame);
    m_detail->follow(frame);
    // A new stock is fitted into the view; the same stock after more cuts leaves the view unchanged.
    if (frame != nullptr && !(m_fitted && frame->zmap.stock() == m_fittedStock)) {
        m_fitted = true;
        m_fittedStock = frame->zmap.stock();
        fit();
    }
    limitZoom();
    m_contact->follow(frame);
    repaintSoon();
}

void Viewport::moved() {
    leaveTheSolid(m_camera, m_frame.get());
    m_fits = false;
    m_place->probeAgain();
    repaintSoon();
}

void Viewport::limitZoom() {
    if (hasStock())
        proveout::limitZoom(m_camera, *m_frame, m_look.picture().get());
}

void Viewport::setOptions(const SceneOptions& options) {
    const SceneColours colours = m_options.colours;
    m_options = options;
    m_options.colours = colours;
    followOptions();
}

void Viewport::setLegendShown(bool shown) {
    m_legend = shown;
    followOptions();
}

void Viewport::followOptions() {
    showSwitches(*this, *m_commands);
    m_commands->find("hide-contact")->setEnabled(m_session.contact().isShown());
    m_part->followOptions();
    for (const char* id : {"view-deviation", "view-part"})
        m_commands->find(id)->setEnabled(m_part->isAvailable());
    repaintSoon();
}

bool Viewport::placeLabelShown() const {
    return m_place->labelShown();
}

void Viewport::setPlaceLabelShown(bool shown) {
    m_place->setLabelShown(shown);
    followOptions();
}

void Viewport::followPalette() {
    m_options.colours = isDark(palette()) ? darkColours() : lightColours();
    repaintSoon();
}

void Viewport::setStandardView(StandardView view) {
    m_camera.setStandardView(view);
    fit();
}

void Viewport::setPerspective(bool perspective) {
    m_camera.setPerspective(perspective);
    leaveTheSolid(m_camera, m_frame.get());
    m_place->probeAgain();
    followOptions();
}

void Viewport::fit() {
    setPicture();
    if (hasStock())
        m_camera.fit(workBounds(*m_frame, m_options));
    else if (m_session.program().current() != nullptr)
        m_camera.fit(m_session.program().current()->bounds());
    m_fits = true;
    m_place->probeAgain();
    repaintSoon();
}

void Viewport::setPicture() {
    const double ratio = devicePixelRatioF();
    m_camera.setPicture(static_cast<int>(std::lround(width() * ratio)),
                        static_cast<int>(std::lround(height() * ratio)), ratio);
}

// --- drawing

void Viewport::initializeGL() {
    m_picture->initialize();
}

void Viewport::resizeGL(int, int) {
    setPicture();
    if (m_fits)
        fit();
    m_picture->resized();
    m_detail->place();
}

void Viewport::paintGL() {
    setPicture();
    Box3 bounds = sceneBounds(m_frame.get(), m_options);
    bounds.add(m_part->bounds());
    const View view = m_camera.view(bounds);
    const std::optional<ScenePicture::Seconds> took = m_picture->paint(view, m_frame);
    if (m_frame != nullptr && took)
        m_session.playback().reportDrawn(m_frame->sequence, took->upload, took->draw,
                                         !m_picture->hasTooManyTriangles());
    paintOver(view);
}

void Viewport::paintOver(const View& view) {
    // Not on the widget itself, because while a window is grabbed, a painter on a widget draws to another
    // device.
    QOpenGLPaintDevice device(QSize(view.pixels.x, view.pixels.y));
    device.setDevicePixelRatio(view.pixelRatio);
    QPainter painter(&device);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font());
    paintOverlay(painter, rect(), view, {*m_picture, m_frame.get(), m_options, *m_part, m_legend, palette()});
    if (!m_picture->isUsable() || m_frame == nullptr)
        return;
    const glm::vec3 colour = m_options.colours.box;
    m_detail->paint(painter, m_camera, QColor::fromRgbF(colour.r, colour.g, colour.b),
                    m_look.picture() != nullptr && !m_picture->boxPending());
}

// --- the detail region

void Viewport::toggleCloserLook() {
    if (looksCloser())
        return closeLook();
    if (!hasStock())
        return followOptions();
    choose(Choosing::box);
    m_detail->open();
    followLook();
}

bool Viewport::looksCloser() const {
    return m_choosing == Choosing::box || m_look.box().has_value();
}

void Viewport::closeLook() {
    choose(Choosing::nothing);
    m_detail->close();
}

void Viewport::followLook() {
    m_detail->place();
    limitZoom();
    followOptions();
}

void Viewport::choose(Choosing what) {
    m_choosing = what;
    if (what == Choosing::nothing)
        unsetCursor();
    else
        setCursor(Qt::CrossCursor);
}

void Viewport::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange) {
        followPalette();
    } else if (event->type() == QEvent::LanguageChange) {
        setAccessibleName(tr("3D view"));
        m_commands->retranslate();
        repaintSoon();
    }
    QOpenGLWidget::changeEvent(event);
}

} // namespace proveout
