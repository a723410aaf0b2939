// SPDX-License-Identifier: GPL-3.0-or-later
// The stock in the colours of its deviation from the part, and the part itself, pixel by pixel.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include <QTest>

#include "core/part/deviation.h"
#include "tests/ui/viewport/frame_builder.h"
#include "tests/ui/viewport/offscreen_picture.h"

using namespace proveout;

namespace {

const StockBox kStock{{0, 0, 0}, 100, 70, 20};
const Vec3 kLeftOn(80, 35, 0);
const Vec3 kExact(50, 35, -2);
const Vec3 kGouged(20, 35, -2.5);

std::shared_ptr<const DesignPart> block(const Vec3& lo, const Vec3& hi) {
    TriangleMesh mesh;
    for (int k = 0; k < 8; ++k)
        mesh.vertices.emplace_back((k & 1) != 0 ? hi.x : lo.x, (k & 2) != 0 ? hi.y : lo.y,
                                   (k & 4) != 0 ? hi.z : lo.z);
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return std::make_shared<const DesignPart>(std::move(mesh));
}

/// Of a part with its top at Z-2: 0.5 mm too deep from x = 0 to 33, to size up to 66, uncut from there.
double steps(double x, double /*y*/) {
    return x < 33 ? -2.5 : x < 66 ? -2 : 0;
}

Camera fromAbove() {
    Box3 box;
    box.add(Vec3(0, 0, -20));
    box.add(Vec3(100, 70, 0));
    return cameraFitted(box, StandardView::top, false, 640, 400);
}

SceneOptions coloured() {
    SceneOptions options = testOptions();
    options.deviation = true;
    return options;
}

QColor at(const QImage& picture, const Vec3& place) {
    const Vec2 pixel = fromAbove().project(place);
    return picture.pixelColor(static_cast<int>(pixel.x), static_cast<int>(pixel.y));
}

/// Light changes how bright a colour is, and hardly which one: the cosine between both.
double likeness(const QColor& pixel, const glm::vec3& colour) {
    const glm::vec3 seen(pixel.redF(), pixel.greenF(), pixel.blueF());
    return double{glm::dot(glm::normalize(seen), glm::normalize(colour))};
}

bool isGrey(const QColor& pixel) {
    const auto [least, most] = std::minmax({pixel.red(), pixel.green(), pixel.blue()});
    return most - least < 25;
}

glm::dvec3 linear(const glm::vec3& colour) {
    const auto channel = [](double value) {
        return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
    };
    return {channel(colour.r), channel(colour.g), channel(colour.b)};
}

/// CIE L*a*b* of a linear colour, D65.
glm::dvec3 lab(const glm::dvec3& rgb) {
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116; };
    const double x = f((0.4124 * rgb.r + 0.3576 * rgb.g + 0.1805 * rgb.b) / 0.9505);
    const double y = f(0.2126 * rgb.r + 0.7152 * rgb.g + 0.0722 * rgb.b);
    const double z = f((0.0193 * rgb.r + 0.1192 * rgb.g + 0.9505 * rgb.b) / 1.089);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// What an eye sees; by rows.
using Sight = std::array<glm::dvec3, 3>;
constexpr Sight kFull{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
// Machado, Oliveira, Fernandes 2009, severity 1.
constexpr Sight kProtanopia{
    {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
constexpr Sight kDeuteranopia{
    {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};

glm::dvec3 seen(const glm::vec3& colour, const Sight& sight) {
    const glm::dvec3 rgb = linear(colour);
    return lab(glm::clamp(
        glm::dvec3(glm::dot(sight[0], rgb), glm::dot(sight[1], rgb), glm::dot(sight[2], rgb)), 0.0, 1.0));
}

} // namespace

class DeviationColoursTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void cleanupTestCase() { m_picture.reset(); }
    void bandsHaveTheirColours();
    void isHatchedWhereGouged();
    void toleranceAndAllowanceMoveTheBands();
    void otherHeightsStayPlain();
    void anotherStockStaysPlain();
    void uploadsInSlices();
    void memoryIsForHeightsFirst();
    void isDrawnInPages();
    void partIsSeenThroughTheStock();
    void coloursDifferInEveryEye();

private:
    [[nodiscard]] QImage draw(const FramePtr& frame, const Deviation* deviation,
                              const PartTolerance& tolerance = {}) {
        (void)m_picture->draw(frame, fromAbove().view({}), testOptions()); // uploads it
        m_picture->renderer().uploadDeviation(deviation, tolerance);
        return m_picture->draw(frame, fromAbove().view({}), coloured());
    }

    std::unique_ptr<OffscreenPicture> m_picture;
    std::shared_ptr<const DesignPart> m_part = block({0, 0, -20}, {100, 70, -2});
    DeviationColours m_colours;
};

void DeviationColoursTest::initTestCase() {
    m_picture = std::make_unique<OffscreenPicture>();
    if (!m_picture->usable())
        QSKIP("no OpenGL 3.3 here");
}

void DeviationColoursTest::bandsHaveTheirColours() {
    FrameBuilder builder(kStock, 1);
    builder.cutAll(steps);
    const FramePtr frame = builder.frame();
    const auto deviation = Deviation::of(frame->zmap, m_part, {});
    const QImage plain = draw(frame, nullptr);
    QVERIFY(m_picture->renderer().colouring() == Colouring::none);
    for (const Vec3& place : {kLeftOn, kExact, kGouged})
        QVERIFY(isGrey(at(plain, place)));
    const QImage picture = draw(frame, &*deviation);
    QVERIFY(m_picture->renderer().colouring() == Colouring::whole);
    QVERIFY(likeness(at(picture, kLeftOn), m_colours.excess) > 0.995);
    QVERIFY(likeness(at(picture, kExact), m_colours.exact) > 0.999);
    QVERIFY(likeness(at(picture, kGouged), m_colours.gouge) > 0.995);
    QVERIFY(m_picture->draw(frame, fromAbove().view({}), testOptions()) == plain); // switched off
}

void DeviationColoursTest::isHatchedWhereGouged() {
    FrameBuilder builder(kStock, 1);
    builder.cutAll(steps);
    const auto deviation = Deviation::of(builder.frame()->zmap, m_part, {});
    const QImage picture = draw(builder.frame(), &*deviation);
    const auto spread = [&](const Vec3& place) {
        const Vec2 middle = fromAbove().project(place);
        int least = 255;
        int most = 0;
        for (int x = -10; x <= 10; ++x) {
            const int value =
                qGray(picture.pixel(static_cast<int>(middle.x) + x, static_cast<int>(middle.y)));
            least = std::min(least, value);
            most = std::max(most, value);
        }
        return most - least;
    };
    QVERIFY(spread(kGouged) > 25);
    QVERIFY(spread(kExact) < 10 && spread(kLeftOn) < 10);
}

void DeviationColoursTest::toleranceAndAllowanceMoveTheBands() {
    FrameBuilder builder(kStock, 1);
    builder.cutAll(steps);
    const FramePtr frame = builder.frame();
    const auto deviation = Deviation::of(frame->zmap, m_part, {0, 0, 0});
    const QImage wide = draw(frame, &*deviation, {0.51, 2.02, 0});
    QVERIFY(likeness(at(wide, kLeftOn), m_colours.left) > 0.995);
    QVERIFY(likeness(at(wide, kGouged), m_colours.missing) > 0.995);
    const QImage allowed = draw(frame, &*deviation, {0.1, 0.1, 2});
    QVERIFY(likeness(at(allowed, kLeftOn), m_colours.exact) > 0.999);
    QVERIFY(likeness(at(allowed, kExact), m_colours.gouge) > 0.995);
}

void DeviationColoursTest::otherHeightsStayPlain() {
    FrameBuilder builder(kStock, 1);
    builder.cutAll(steps);
    const auto deviation = Deviation::of(builder.frame()->zmap, m_part, {});
    (void)draw(builder.frame(), &*deviation);
    builder.cut({0, 0, 33, 71}, [](double, double) { return -3; }); // the first column of tiles
    // Even if nothing is uploaded again before it is drawn.
    const QImage picture = m_picture->draw(builder.frame(), fromAbove().view({}), coloured());
    QVERIFY(isGrey(at(picture, kGouged)) && isGrey(at(picture, kExact)));
    QVERIFY(likeness(at(picture, kLeftOn), m_colours.excess) > 0.995);
    const QImage again = draw(builder.frame(), &*deviation);
    QVERIFY(isGrey(at(again, kGouged)));
    QVERIFY(m_picture->renderer().colouring() == Colouring::whole);
}

void DeviationColoursTest::anotherStockStaysPlain() {
    FrameBuilder builder(kStock, 1);
    builder.cutAll(steps);
    const auto deviation = Deviation::of(builder.frame()->zmap, m_part, {});
    (void)draw(builder.frame(), &*deviation);
    StockBox higher = kStock;
    higher.corner.z = 5;
    FrameBuilder other(higher, 1);
    const QImage picture = draw(other.frame(), &*deviation);
    QVERIFY(isGrey(at(picture, kGouged)) && isGrey(at(picture, kLeftOn)));
}

void DeviationColoursTest::uploadsInSlices() {
    FrameBuilder builder(kStock, 0.5);
    builder.cutAll(steps);
    const FramePtr frame = builder.frame();
    const auto deviation = Deviation::of(frame->zmap, m_part, {});
    (void)draw(frame, nullptr);
    SceneRenderer& renderer = m_picture->renderer();
    std::size_t calls = 0;
    do {
        renderer.uploadDeviation(&*deviation, {}, UploadBudget(std::chrono::seconds(0)));
        ++calls;
    } while (renderer.colouring() == Colouring::pending && calls < 100);
    QCOMPARE(calls, frame->zmap.tileCount() + 1); // the last one has nothing to do
    const QImage slices = m_picture->draw(frame, fromAbove().view({}), coloured());
    QVERIFY(slices == draw(frame, &*deviation));
}

void DeviationColoursTest::memoryIsForHeightsFirst() {
    FrameBuilder builder(kStock, 0.5);
    builder.cutAll(steps);
    const FramePtr frame = builder.frame();
    const auto deviation = Deviation::of(frame->zmap, m_part, {});
    OffscreenPicture limited;
    (void)limited.draw(frame, fromAbove().view({}), coloured());
    const std::size_t held = limited.renderer().memoryHeld();
    for (const bool enough : {false, true}) {
        limited.renderer().setMemory(enough ? 4 * held : held + 100);
        (void)limited.draw(frame, fromAbove().view({}), coloured());
        limited.renderer().uploadDeviation(&*deviation, {});
        QVERIFY(limited.renderer().colouring() == (enough ? Colouring::whole : Colouring::tooLarge));
        const QImage picture = limited.draw(frame, fromAbove().view({}), coloured());
        QCOMPARE(isGrey(at(picture, kLeftOn)), !enough);
    }
    // Heights that are not all held are not coloured either.
    limited.renderer().setMemory(90'000);
    (void)limited.draw(frame, fromAbove().view({}), coloured());
    limited.renderer().uploadDeviation(&*deviation, {});
    QVERIFY(limited.renderer().colouring() == Colouring::tooLarge);
    QVERIFY(isGrey(at(limited.draw(frame, fromAbove().view({}), coloured()), kLeftOn)));
}

void DeviationColoursTest::isDrawnInPages() {
    FrameBuilder builder(kStock, 0.5);
    builder.cutAll(steps);
    const FramePtr frame = builder.frame();
    const auto deviation = Deviation::of(frame->zmap, m_part, {});
    OffscreenPicture pages(64);
    (void)pages.draw(frame, fromAbove().view({}), coloured());
    pages.renderer().uploadDeviation(&*deviation, {});
    const QImage divided = pages.draw(frame, fromAbove().view({}), coloured());
    const QImage whole = draw(frame, &*deviation);
    for (double x = 1; x < 100; x += 1)
        for (const double y : {10.3, 35.1, 66.7})
            QVERIFY(likeness(at(divided, {x, y, 0}),
                             glm::vec3(at(whole, {x, y, 0}).redF(), at(whole, {x, y, 0}).greenF(),
                                       at(whole, {x, y, 0}).blueF())) > 0.999);
}

void DeviationColoursTest::partIsSeenThroughTheStock() {
    FrameBuilder builder(kStock, 1);
    builder.cutAll([](double x, double) { return x < 50 ? -10 : 0; }); // the part is before it, and in it
    const auto part = block({10, 20, -19}, {90, 50, -2});
    SceneOptions options = testOptions();
    const QImage plain = m_picture->draw(builder.frame(), fromAbove().view({}), options);
    options.part = true;
    const auto strength = [](const QImage& image, const Vec3& place) { // of the green
        const QColor pixel = at(image, place);
        return pixel.green() - pixel.red();
    };
    SceneRenderer& renderer = m_picture->renderer();
    for (int slices = 0; slices < 2; ++slices)
        renderer.uploadPart(part, UploadBudget(std::chrono::seconds(0)));
    QVERIFY(!renderer.partPending());
    const QImage picture = m_picture->draw(builder.frame(), fromAbove().view({}), options);
    const int before = strength(picture, {30, 35, -2});
    const int within = strength(picture, {70, 35, 0});
    QVERIFY2(before > 25 && within > 10 && before > within,
             qPrintable(QStringLiteral("%1 %2").arg(before).arg(within)));
    QCOMPARE(at(picture, {50, 5, 0}), at(plain, {50, 5, 0})); // beside it
    renderer.uploadPart(nullptr);
    QVERIFY(m_picture->draw(builder.frame(), fromAbove().view({}), options) == plain);
}

/// UX: bands that must not be confused differ, whatever the eye; excess and gouge are a colour and a
/// hatching.
void DeviationColoursTest::coloursDifferInEveryEye() {
    constexpr double kClear = 20; // differences of 2 are just visible
    const SceneColours scene = lightColours();
    const std::array bands{m_colours.excess, m_colours.exact, m_colours.gouge, scene.rawStock};
    for (const Sight& sight : {kFull, kProtanopia, kDeuteranopia}) {
        for (std::size_t a = 0; a < bands.size(); ++a)
            for (std::size_t b = a + 1; b < bands.size(); ++b)
                QVERIFY2(glm::distance(seen(bands[a], sight), seen(bands[b], sight)) > kClear,
                         qPrintable(QStringLiteral("%1 %2").arg(a).arg(b)));
        // What is allowed is nearer to what is exact than to what is not allowed.
        for (const auto& [allowed, not_allowed] :
             {std::pair{m_colours.left, m_colours.excess}, std::pair{m_colours.missing, m_colours.gouge}})
            QVERIFY(glm::distance(seen(allowed, sight), seen(not_allowed, sight)) > kClear);
        QVERIFY(glm::distance(seen(m_colours.left, sight), seen(m_colours.missing, sight)) > kClear);
    }
    // In grey.
    const double within = seen(m_colours.exact, kFull).x;
    QVERIFY(within - seen(m_colours.excess, kFull).x > kClear);
    QVERIFY(within - seen(m_colours.gouge, kFull).x > kClear);
}

QTEST_MAIN(DeviationColoursTest)

#include "deviation_colours_test.moc"
