// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/setup/tool_form.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QImage>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

#include "tests/core/cutter/default_spec.h"
#include "ui/setup/tool_drawing.h"

namespace proveout {

class ToolFormTest : public QObject {
    Q_OBJECT

private slots:
    void everyShapeIsProposedAsACutterThatCanBe() {
        ToolForm form;
        QSignalSpy edited(&form, &ToolForm::edited);
        QCOMPARE(shapes(form).count(), static_cast<int>(cutterShapes().size()));
        for (const CutterShape& shape : cutterShapes()) {
            choose(form, shape.key);
            QCOMPARE(form.spec().shape, std::string(shape.key));
            for (const ShapeKey& key : shape.keys)
                QVERIFY2(form.findChild<QWidget*>(nameOf(key.key)) != nullptr, key.key);
        }
        QCOMPARE(edited.size(), static_cast<int>(cutterShapes().size()));
    }

    void aSpecOfEveryShapeComesBackAsItWas() {
        for (const CutterShape& shape : cutterShapes()) {
            const std::string spec = defaultSpecOf(shape);
            ToolForm form;
            form.show(readSpec(spec));
            const Result<Cutter> shown = parseCutter(writeSpec(form.spec()));
            QVERIFY2(shown.has_value(), spec.c_str());
            QCOMPARE(shown->pieces().size(), parseCutter(spec)->pieces().size());
            QCOMPARE(readSpec(writeSpec(form.spec())).values, form.spec().values);
            QCOMPARE(readSpec(writeSpec(form.spec())).texts, form.spec().texts);
        }
    }

    void whatBothShapesMeanBySameNameStays() {
        ToolForm form;
        form.show(readSpec("flat:d=8,l=33"));
        choose(form, "drill");
        QCOMPARE(form.spec().values.at("d"), 8.0);
        QCOMPARE(form.spec().values.at("l"), 33.0);
        box<QDoubleSpinBox>(form, "angle").setValue(140);
        choose(form, "spot");
        QCOMPARE(form.spec().values.at("angle"), 140.0);
        choose(form, "taper");
        QCOMPARE(form.spec().values.at("angle"), 3.0); // for a side, not for the point
        QCOMPARE(form.spec().values.at("d"), 6.0);     // at the tip
        QCOMPARE(form.spec().values.at("l"), 33.0);
    }

    void theDrawingIsToScale() {
        // A flat mill with flutes twice as long as wide, below a holder four times as wide.
        ToolDrawing drawing;
        drawing.resize(300, drawing.sizeHint().height());
        drawing.show(parseCutter("flat:d=10,l=20,so=30,sd=10,holder=40x10").value());
        QImage picture(drawing.size(), QImage::Format_RGB32);
        drawing.render(&picture);
        const auto filled = [&](int x, int y) {
            return picture.pixelColor(x, y).lightness() !=
                   drawing.palette().color(QPalette::Window).lightness();
        };
        const int bottom = [&] { // of the flutes, below which is the axis and the diameter
            for (int y = picture.height() - 1; y > 0; --y)
                if (filled(picture.width() / 2 - 4, y) && filled(picture.width() / 2 - 4, y - 8))
                    return y;
            return 0;
        }();
        const auto width = [&](int y) {
            int left = picture.width() / 2;
            while (left > 0 && filled(left, y))
                --left;
            int right = picture.width() / 2;
            while (right < picture.width() && filled(right, y))
                ++right;
            return right - left - 1;
        };
        int top = 0;
        while (!filled(picture.width() / 2 - 4, top))
            ++top;
        const double scale = (bottom - top) / 40.0; // px per mm
        const double line = 4;                      // px, of both outlines
        QVERIFY(scale > 2);
        QVERIFY(qAbs(width(bottom - 10) - 10 * scale) <= line);
        QVERIFY(qAbs(width(bottom - qRound(25 * scale)) - 10 * scale) <= line);
        QVERIFY(qAbs(width(bottom - qRound(35 * scale)) - 40 * scale) <= line);
        drawing.show({});
        drawing.render(&picture);
        QVERIFY(!filled(picture.width() / 2, picture.height() / 2));
    }

    void aHolderIsEditedAsTextAndStaysWithAnotherShape() {
        ToolForm form;
        form.show(readSpec("flat:d=8,so=40,holder=40x30"));
        auto& holder = box<QLineEdit>(form, "holder");
        QCOMPARE(holder.text(), QStringLiteral("40x30"));
        QVERIFY(holder.toolTip().contains(QLatin1String("40x30+40-60x15")));
        choose(form, "form");
        QCOMPARE(form.spec().texts.at("holder"), std::string("40x30"));
        QCOMPARE(form.spec().values.at("so"), 40.0);
        choose(form, "ball");
        QCOMPARE(writeSpec(form.spec()), std::string("ball:d=10,so=40,holder=40x30"));
    }

    void anotherShapeHasItsOwnDefaults() {
        ToolForm form;
        form.show(readSpec("flat:d=8"));
        QCOMPARE(form.spec().values.at("centre"), 1.0);
        choose(form, "face");
        QCOMPARE(form.spec().values.at("centre"), 0.0);
        box<QDoubleSpinBox>(form, "centre").setValue(1);
        choose(form, "tslot");
        QCOMPARE(form.spec().values.at("centre"), 1.0);
        choose(form, "ball");
        QCOMPARE(writeSpec(form.spec()), std::string("ball:d=8"));
    }

    void aProfileIsEditedAsText() {
        ToolForm form;
        form.show(readSpec("form:p=0/0:3/0:4/1@1,l=20"));
        auto& profile = box<QLineEdit>(form, "p");
        QCOMPARE(profile.text(), QStringLiteral("0/0:3/0:4/1@1"));
        QVERIFY(profile.toolTip().contains(QLatin1String("4/1@3/1")));
        QSignalSpy edited(&form, &ToolForm::edited);
        profile.setText(QStringLiteral("0/0:5/2"));
        emit profile.editingFinished();
        QCOMPARE(edited.size(), 1);
        QCOMPARE(writeSpec(form.spec()), std::string("form:p=0/0:5/2,l=20"));
        emit profile.editingFinished(); // as when the focus leaves, with nothing changed
        QCOMPARE(edited.size(), 1);
    }

private:
    static QString nameOf(const char* key) { return QStringLiteral("tool-") + QLatin1String(key); }
    static QComboBox& shapes(const ToolForm& form) { return *form.findChild<QComboBox*>(); }
    template<class Box>
    static Box& box(const ToolForm& form, const char* key) {
        return *form.findChild<Box*>(nameOf(key));
    }
    static void choose(const ToolForm& form, const char* shape) {
        QComboBox& box = shapes(form);
        box.setCurrentIndex(box.findData(QLatin1String(shape)));
        emit box.activated(box.currentIndex());
    }
};

} // namespace proveout

QTEST_MAIN(proveout::ToolFormTest)
#include "tool_form_test.moc"
