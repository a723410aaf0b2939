// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/viewport.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <QApplication>
#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLPaintDevice>
#include <QPainter>

#include "ui/surface_probe.h"
#include "ui/theme.h"
#include "ui/viewport/closer_look_form.h"
#include "ui/viewport/foreign_notice.h"
#include "ui/viewport/hud.h"
#include "ui/viewport/place_label.h"
#include "ui/viewport/surface_pick.h"
#include "ui/viewport/tool_notice.h"
#include "ui/viewport/viewport_commands.h"

namespace proveout {
namespace {

constexpr double kFewestCellsShown = 4;       ///< of the grid, across the picture's height
constexpr double kSmallestShareOfView = 0.05; ///< of the stock in the picture's height
constexpr int kRestMilliseconds = 250;
/// What a box of interest may take of the UI thread at once to go to the graphics side.
constexpr std::chrono::milliseconds kUploadAtOnce{25};
/// A smoothed picture in software takes about this many times as long as a plain one …
constexpr double kSmoothCost = 4;
/// … and must not hold up the window longer than this.
constexpr double kLongestSmoothSeconds = 0.25;

double seconds(const QElapsedTimer& timer) {
    return static_cast<double>(timer.nsecsElapsed()) * 1e-9;
}

} // namespace

Viewport::Viewport(Session& session, const GlSupport& support, QWidget* parent)
    : QOpenGLWidget(parent), m_session(session), m_support(support), m_form(new CloserLookForm(m_look, this)),
      m_probe(new SurfaceProbe(this)), m_placeLabel(new PlaceLabel(this)) {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    // Four samples a pixel triple the cost of a picture in software; there, only pictures at rest are
    // smoothed.
    format.setSamples(support.software ? 0 : 4);
    setFormat(format);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(160, 120);

    m_commands =
        std::make_unique<CommandActions<Viewport>>(*this, kViewportCommandContext, viewportCommands(), this);
    for (QAction* action : m_commands->all()) {
        action->setCheckable(isOn(*this, action->objectName().toStdString()).has_value());
        addAction(action);
        // A click flips the tick by itself; what is on decides.
        connect(action, &QAction::triggered, this, &Viewport::followOptions);
    }
    setAccessibleName(tr("3D view"));
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestMilliseconds);
    connect(&m_rest, &QTimer::timeout, this, [this] {
        m_smooth = true;
        update();
    });
    m_uploading.setSingleShot(true);
    connect(&m_uploading, &QTimer::timeout, this, &Viewport::goOnUploading);
    m_form->hide();
    connect(m_form, &CloserLookForm::closed, this, &Viewport::closeLook);
    connect(m_form, &CloserLookForm::edited, this, &Viewport::followForm);
    connect(&m_look, &CloserLook::changed, this, &Viewport::followLook);
    connect(&session.playback(), &PlaybackHub::tick, this, &Viewport::onTick);
    connect(m_probe, &SurfaceProbe::answered, &session.playback(), &PlaybackHub::requestTick);
    new ToolNotice(session, this);
    new ForeignNotice(session, this);
    followPalette();
    followOptions();
    setFrame(session.simulation().frame());
}

Viewport::~Viewport() {
    // The base class destroys the context after our members are gone: it must not call us then.
    if (context() != nullptr)
        disconnect(context(), nullptr, this, nullptr);
    makeCurrent();
    releaseGl();
    doneCurrent();
}

void Viewport::onTick(const FramePtr& frame) {
    setFrame(frame);
    probeSurface();
}

void Viewport::setFrame(const FramePtr& frame) {
    if (frame == m_frame)
        return;
    m_frame = frame;
    if (looksCloser() && (frame == nullptr || frame->zmap.stock() != m_fittedStock))
        closeLook(); // a box of another stock says nothing
    m_look.follow(frame);
    // Another stock comes into the picture as a whole; the same one cut further leaves the view alone.
    if (frame != nullptr && !(m_fitted && frame->zmap.stock() == m_fittedStock)) {
        m_fitted = true;
        m_fittedStock = frame->zmap.stock();
        fit();
    }
    if (frame != nullptr && frame->zmap.tileCount() > 0)
        limitZoom();
    repaintSoon();
}

void Viewport::moved() {
    leaveTheSolid();
    m_fits = false;
    probeAgain();
    repaintSoon();
}

void Viewport::limitZoom() {
    const ZMapSnapshot& zmap = m_frame->zmap;
    const StockBox& stock = zmap.stock();
    const double radius = 0.5 * std::hypot(stock.width, stock.depth, stock.height);
    const Grid& grid = m_look.picture() != nullptr ? m_look.picture()->zmap.grid() : zmap.grid();
    const double cells = kFewestCellsShown * std::max(grid.hx, grid.hy);
    m_camera.limitZoom(0.5 * std::min(cells, radius), radius / kSmallestShareOfView);
}

void Viewport::leaveTheSolid() {
    // An eye in the solid would see its inner sides, which are not there: it backs off.
    constexpr double kStep = 1.1;
    constexpr int kMostSteps = 100;
    if (m_frame == nullptr || !m_camera.perspective())
        return;
    for (int step = 0; step < kMostSteps && isInStock(m_frame->zmap, m_camera.eye()); ++step)
        m_camera.zoom(kStep, m_camera.target());
}

void Viewport::repaintSoon() {
    m_smooth = false;
    m_rest.stop();
    update();
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
    for (QAction* action : m_commands->all())
        if (const auto on = isOn(*this, action->objectName().toStdString()))
            action->setChecked(*on);
    repaintSoon();
}

void Viewport::setPlaceLabelShown(bool shown) {
    m_placeLabelShown = shown;
    probeAgain();
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
    leaveTheSolid();
    probeAgain();
    followOptions();
}

void Viewport::fit() {
    setPicture();
    Box3 box;
    if (m_frame != nullptr && m_frame->zmap.tileCount() > 0) {
        const StockBox& stock = m_frame->zmap.stock();
        box.add(Vec3(stock.corner.x, stock.corner.y, stock.floorZ()));
        box.add(Vec3(stock.corner.x + stock.width, stock.corner.y + stock.depth, stock.topZ()));
    } else if (m_session.program().current() != nullptr) {
        box = m_session.program().current()->bounds();
    }
    m_camera.fit(box);
    m_fits = true;
    probeAgain();
    repaintSoon();
}

void Viewport::setPicture() {
    const double ratio = devicePixelRatioF();
    m_camera.setPicture(static_cast<int>(std::lround(width() * ratio)),
                        static_cast<int>(std::lround(height() * ratio)), ratio);
}

Box3 Viewport::sceneBox() const {
    Box3 box;
    if (m_frame == nullptr)
        return box;
    const StockBox& stock = m_frame->zmap.stock();
    box.add(Vec3(stock.corner.x, stock.corner.y, stock.floorZ()));
    box.add(Vec3(stock.corner.x + stock.width, stock.corner.y + stock.depth, stock.topZ()));
    if (m_frame->program != nullptr && m_options.path != PathShown::none)
        box.add(m_frame->program->bounds());
    const Cutter* cutter =
        m_frame->cutterKnown && m_frame->setup ? m_frame->setup->tools.find(m_frame->tool) : nullptr;
    if (cutter != nullptr) {
        const double radius = std::max(cutter->radius(), cutter->shankRadius());
        const double length =
            2 * std::max(cutter->fluteLength(), cutter->rimHeight()) + cutter->shankLength();
        box.add(m_frame->cutterPosition - Vec3(radius, radius, 0));
        box.add(m_frame->cutterPosition + Vec3(radius, radius, length));
    }
    return box;
}

// --- drawing

void Viewport::initializeGL() {
    // The context goes when the widget moves to another window or the driver resets it; a new one comes with
    // another call of this function.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] {
        makeCurrent();
        releaseGl();
        doneCurrent();
    });
    m_renderer = SceneRenderer::create();
}

void Viewport::releaseGl() {
    m_smoothTarget.reset();
    if (m_renderer != nullptr)
        m_renderer->release();
    m_renderer.reset();
}

void Viewport::resizeGL(int, int) {
    setPicture();
    if (m_fits)
        fit();
    m_smooth = false;
    placeForm();
}

void Viewport::paintGL() {
    setPicture();
    const View view = m_camera.view(sceneBox());
    double uploadSeconds = 0;
    double drawSeconds = 0;
    if (m_renderer != nullptr) {
        QElapsedTimer timer;
        timer.start();
        m_uploaded = m_renderer->upload(m_frame);
        m_boxFits = m_renderer->uploadBox(m_look.picture(), UploadBudget(kUploadAtOnce));
        if (!m_look.box())
            m_renderer->releaseBox();
        if (showsHiddenPath())
            m_renderer->advancePath(UploadBudget(kUploadAtOnce));
        // Waiting for the end costs nothing at 30 pictures a second and makes the figures honest.
        m_renderer->finish();
        uploadSeconds = seconds(timer);
        timer.restart();
        drawScene(view);
        m_renderer->finish();
        drawSeconds = seconds(timer);
        if (!m_smooth)
            m_plainSeconds = drawSeconds;
    }
    if (m_frame != nullptr)
        m_session.playback().reportDrawn(m_frame->sequence, uploadSeconds, drawSeconds);
    paintOverlay(view);
    if (workPending())
        m_uploading.start(0);
    const bool worthIt = m_support.software && kSmoothCost * m_plainSeconds < kLongestSmoothSeconds;
    if (worthIt && !m_smooth && m_frame != nullptr && !m_frame->playing)
        m_rest.start();
}

bool Viewport::showsHiddenPath() const {
    return m_options.pathThroughStock && m_options.path != PathShown::none;
}

/// What a picture waits for without holding up the window.
bool Viewport::workPending() const {
    return m_renderer != nullptr &&
           (m_renderer->boxPending() || (showsHiddenPath() && m_renderer->pathPending()));
}

/// Between the events of the window, and without a picture that shows nothing new.
void Viewport::goOnUploading() {
    if (m_renderer == nullptr)
        return;
    makeCurrent();
    m_boxFits = m_renderer->uploadBox(m_look.picture(), UploadBudget(kUploadAtOnce));
    m_renderer->finish();
    doneCurrent();
    if (showsHiddenPath())
        m_renderer->advancePath(UploadBudget(kUploadAtOnce));
    if (workPending())
        m_uploading.start(0);
    else
        repaintSoon();
}

void Viewport::drawScene(const View& view) {
    if (m_smooth)
        drawSmooth(view);
    else
        m_renderer->draw(view, m_options);
}

void Viewport::drawSmooth(const View& view) {
    const QSize size(view.pixels.x, view.pixels.y);
    if (m_smoothTarget == nullptr || m_smoothTarget->size() != size) {
        QOpenGLFramebufferObjectFormat format;
        format.setAttachment(QOpenGLFramebufferObject::Depth);
        format.setSamples(4);
        m_smoothTarget = std::make_unique<QOpenGLFramebufferObject>(size, format);
    }
    m_smoothTarget->bind();
    m_renderer->draw(view, m_options);
    m_renderer->copyPicture(m_smoothTarget->handle(), defaultFramebufferObject(), view.pixels);
}

void Viewport::paintOverlay(const View& view) {
    // Not the widget itself: while a window is grabbed, a painter on a widget draws elsewhere.
    QOpenGLPaintDevice device(QSize(view.pixels.x, view.pixels.y));
    device.setDevicePixelRatio(view.pixelRatio);
    QPainter painter(&device);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(font());
    if (m_renderer == nullptr) {
        painter.fillRect(rect(), palette().window());
        paintNotice(painter, rect(), tr("A shader failed to compile; see the log."), palette());
        return;
    }
    paintAxes(painter, rect(), view, palette().color(QPalette::WindowText));
    if (m_frame == nullptr)
        return;
    if (!m_renderer->gridFits())
        paintNotice(painter, rect(),
                    tr("The grid is too large for the graphics driver; the stock is not drawn. Increase the "
                       "grid spacing."),
                    palette());
    if (!m_boxFits)
        paintNotice(painter, rect(),
                    tr("The detail region is too large for the graphics driver and is not drawn. Increase "
                       "its grid spacing or make the box smaller."),
                    palette());
    if (m_legend)
        paintLegend(painter, rect(), m_options,
                    {m_frame->surface.faces, m_frame->surface.facesFull, m_frame->surface.meshes.size(),
                     m_frame->surface.dirtyRegions},
                    palette());
    if (m_choice)
        paintChoice(painter);
    paintBoxUnderWay(painter);
}

QPolygonF Viewport::outlineOf(const PlanBox& box, double level) const {
    QPolygonF outline;
    for (const Vec2& corner : {box.lo, Vec2(box.hi.x, box.lo.y), box.hi, Vec2(box.lo.x, box.hi.y)}) {
        const Vec2 pixel = m_camera.project({corner, level});
        outline << QPointF(pixel.x, pixel.y) / devicePixelRatioF();
    }
    return outline;
}

QPen Viewport::boxPen(Qt::PenStyle style) const {
    const glm::vec3 colour = m_options.colours.box;
    return {QColor::fromRgbF(colour.r, colour.g, colour.b), 2, style};
}

void Viewport::paintChoice(QPainter& painter) const {
    const PlanBox box = m_choice->box(m_frame->zmap.stock(), m_form->size());
    painter.setPen(boxPen(Qt::SolidLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(outlineOf(box, m_choice->level()));
}

/// Until it is cut and shown, where it will be: dashed, from the top of the stock to its floor.
void Viewport::paintBoxUnderWay(QPainter& painter) const {
    const bool shown = m_look.picture() != nullptr && !m_renderer->boxPending();
    if (!m_look.box() || !m_look.working() || shown)
        return;
    const PlanBox& box = m_look.box()->box;
    const StockBox& stock = m_frame->zmap.stock();
    const Vec3 eye = m_camera.eye();
    const Vec3 forward = m_camera.target() - eye;
    for (const double x : {box.lo.x, box.hi.x})
        for (const double y : {box.lo.y, box.hi.y})
            for (const double z : {stock.floorZ(), stock.topZ()})
                if (glm::dot(Vec3(x, y, z) - eye, forward) <= 0)
                    return; // the eye is inside, or has it behind
    const QPolygonF top = outlineOf(box, stock.topZ());
    const QPolygonF floor = outlineOf(box, stock.floorZ());
    painter.setPen(boxPen(Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(top);
    painter.drawPolygon(floor);
    for (int k = 0; k < top.size(); ++k)
        painter.drawLine(top[k], floor[k]);
}

// --- the box of interest

void Viewport::toggleCloserLook() {
    if (looksCloser()) {
        closeLook();
        return;
    }
    if (m_frame == nullptr || m_frame->zmap.tileCount() == 0)
        return followOptions();
    choose(Choosing::box);
    m_form->show();
    followLook();
}

bool Viewport::looksCloser() const {
    return m_choosing == Choosing::box || m_look.box().has_value();
}

void Viewport::closeLook() {
    choose(Choosing::nothing);
    m_choice.reset();
    const QWidget* focus = QApplication::focusWidget();
    if (focus != nullptr && m_form->isAncestorOf(focus))
        setFocus();
    m_form->hide();
    m_look.close();
}

void Viewport::followForm() {
    const auto& box = m_look.box();
    if (!box || m_frame == nullptr)
        return;
    const Vec2 middle = (box->box.lo + box->box.hi) / 2.0;
    m_look.look({boxAbout(middle, m_form->size(), m_frame->zmap.stock()), m_form->spacing()});
}

void Viewport::followLook() {
    placeForm();
    if (m_frame != nullptr && m_frame->zmap.tileCount() > 0)
        limitZoom();
    followOptions();
}

void Viewport::placeForm() {
    constexpr int kMargin = 10;
    m_form->move(width() - m_form->width() - kMargin, kMargin);
}

void Viewport::beginChoice(const QPointF& position) {
    const QPointF pixel = position * devicePixelRatioF();
    const auto hit = pickStock(m_frame->zmap, m_camera.ray(pixel.x(), pixel.y()));
    if (hit)
        m_choice.emplace(*hit, Vec2(pixel.x(), pixel.y()));
    repaintSoon();
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
