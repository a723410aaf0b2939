// SPDX-License-Identifier: GPL-3.0-or-later
// A finding that was chosen shows its contact in the 3D view, until another block is requested.
#include <algorithm>
#include <memory>

#include <QFile>
#include <QMainWindow>
#include <QTemporaryDir>
#include <QTest>

#include "tests/ui/opened.h"
#include "ui/gl/gl_functions.h"
#include "ui/viewport/camera_flight.h"
#include "ui/viewport/viewport.h"

using namespace proveout;

namespace {

constexpr int kPatience = 30'000; // ms

/// A rapid across a clamp; in the last motion block the cutter is beside it again.
const QByteArray kProgram =
    "G21 G90 G17\nT1 M6\nS1000 M3\nG43 H1\nG0 X5 Y20 Z30\nG0 Z3\nG0 X95\nG0 Z30\nM30\n";

bool isHit(QRgb pixel) {
    return qRed(pixel) - qGreen(pixel) > 60 && qRed(pixel) - qBlue(pixel) > 60;
}

} // namespace

class ContactTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void cleanup();
    void aFindingShowsItsContact();
    void anythingElseHidesIt_data();
    void anythingElseHidesIt();
    void aSmallPlaceIsEnlarged();

private:
    [[nodiscard]] const CheckFinding* collision() const;
    [[nodiscard]] QRgb pixelAt(const Vec3& place);

    GlSupport m_support;
    QTemporaryDir m_folder;
    std::unique_ptr<Session> m_session;
    std::unique_ptr<QMainWindow> m_window;
    Viewport* m_view = nullptr;
};

void ContactTest::initTestCase() {
    m_support = probeGl();
    if (!m_support.usable)
        QSKIP("no OpenGL 3.3 here");
}

void ContactTest::init() {
    m_session = std::make_unique<Session>();
    m_window = std::make_unique<QMainWindow>();
    m_window->resize(900, 640);
    m_view = new Viewport(*m_session, m_support, m_window.get());
    m_window->setCentralWidget(m_view);
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    const QString name = m_folder.filePath(QStringLiteral("p.nc"));
    QFile file(name);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(kProgram) == kProgram.size());
    file.close();
    QVERIFY(opened(*m_session, name));
    QTRY_VERIFY_WITH_TIMEOUT(m_session->simulation().frame() != nullptr, kPatience);
    Setup setup = m_session->job().setup();
    setup.stock = StockBox{{0, 0, 0}, 100, 40, 20};
    setup.tools.set(1, parseCutter("flat:d=10,l=20,so=30,holder=30x20").value());
    setup.fixtures = {{"clamp", FixtureBox{40, 0, -20, 20, 40, 28}}};
    QVERIFY(m_session->job().setSetup(setup).has_value());
    QTRY_VERIFY_WITH_TIMEOUT(m_session->check().report() != nullptr, kPatience);
    m_view->setStandardView(StandardView::front);
    m_view->setLegendShown(false);
}

void ContactTest::cleanup() {
    m_window.reset();
    m_session.reset();
}

const CheckFinding* ContactTest::collision() const {
    const auto& findings = m_session->check().report()->findings;
    const auto found = std::ranges::find_if(findings, [](const CheckFinding& one) {
        return QLatin1String(one.diagnostic.id) == QLatin1String("fixture-collision");
    });
    return found == findings.end() ? nullptr : &*found;
}

QRgb ContactTest::pixelAt(const Vec3& place) {
    const Vec2 pixel = m_view->camera().project(place);
    return m_view->grabFramebuffer().pixel(static_cast<int>(pixel.x), static_cast<int>(pixel.y));
}

void ContactTest::aFindingShowsItsContact() {
    QVERIFY(collision() != nullptr);
    const auto line = m_session->contact().show(*collision());
    QCOMPARE(line, std::optional<std::uint32_t>(7));
    const FoundContact* contact = nullptr;
    QTRY_VERIFY_WITH_TIMEOUT((contact = m_session->contact().in(m_session->simulation().frame().get())) !=
                                     nullptr &&
                                 m_view->options().contact.has_value(),
                             kPatience);
    QCOMPARE(contact->fixture, std::string("clamp"));
    QVERIFY(contact->tip.x > 34 && contact->tip.x < 66 && contact->tip.z == 3);
    // The place is in the middle of the view, as seen from the same side.
    const double azimuth = m_view->camera().azimuth();
    QTRY_VERIFY_WITH_TIMEOUT(glm::distance(m_view->camera().target(), contact->place) < 1e-6, 2000);
    QCOMPARE(m_view->camera().azimuth(), azimuth);
    QVERIFY(isHit(pixelAt({42, 0, 4})));                       // the clamp
    QVERIFY(isHit(pixelAt(contact->tip + Vec3(0, -5, 12))));   // the flutes
    QVERIFY(!isHit(pixelAt(contact->tip + Vec3(0, -15, 40)))); // the holder
    QVERIFY(!isHit(pixelAt({20, 0, -10})));                    // the stock
}

void ContactTest::anythingElseHidesIt_data() {
    QTest::addColumn<int>("way");
    QTest::newRow("command") << 0;
    QTest::newRow("seek") << 1;
    QTest::newRow("step") << 2;
    QTest::newRow("play") << 3;
    QTest::newRow("setup") << 4;
    QTest::newRow("text") << 5;
    QTest::newRow("finding without a contact") << 6;
}

void ContactTest::anythingElseHidesIt() {
    QFETCH(int, way);
    QAction* hide = nullptr;
    for (QAction* action : m_view->actions())
        if (action->objectName() == QLatin1String("hide-contact"))
            hide = action;
    QVERIFY(hide != nullptr && !hide->isEnabled());
    QVERIFY(m_session->contact().show(*collision()).has_value());
    QTRY_VERIFY_WITH_TIMEOUT(m_view->options().contact.has_value(), kPatience);
    QVERIFY(hide->isEnabled());
    PlaybackHub& playback = m_session->playback();
    switch (way) {
    case 0:
        hide->trigger();
        QCOMPARE(m_session->simulation().block(), m_session->simulation().target());
        break;
    case 1:
        playback.seek(m_session->simulation().block());
        break;
    case 2:
        playback.step(-1);
        break;
    case 3:
        playback.play();
        break;
    case 4: {
        Setup setup = m_session->job().setup();
        setup.fixtures.clear();
        QVERIFY(m_session->job().setSetup(setup).has_value());
        break;
    }
    case 5:
        m_session->document().applyEdit(0, 0, "(A)\n");
        break;
    default: {
        CheckFinding other = *collision();
        other.diagnostic.id = "spindle-stopped";
        QVERIFY(!m_session->contact().show(other).has_value());
        break;
    }
    }
    QVERIFY(!m_session->contact().isShown());
    QVERIFY(!m_view->options().contact.has_value());
    QVERIFY(!hide->isEnabled());
    QVERIFY(!isHit(pixelAt({42, 0, 4})));
}

void ContactTest::aSmallPlaceIsEnlarged() {
    Camera camera;
    camera.setPicture(800, 600, 2);
    camera.limitZoom(1e-3, 1e6);
    Box3 box;
    box.add(Vec3(0));
    box.add(Vec3(1000, 800, 20));
    camera.fit(box);
    const auto shown = [](const Camera& one, double radius) {
        return 2 * radius * one.view({}).pixelsPerMm / 2;
    };
    const Camera small = centredOn(camera, {500, 400, 20}, 2);
    QVERIFY(shown(camera, 2) < kLeastShown);
    QVERIFY(std::abs(shown(small, 2) - kEnlarged) < 1e-6);
    QCOMPARE(small.target(), Vec3(500, 400, 20));
    const Camera large = centredOn(camera, {500, 400, 20}, 200);
    QCOMPARE(large.halfHeight(), camera.halfHeight());
}

QTEST_MAIN(ContactTest)
#include "contact_test.moc"
