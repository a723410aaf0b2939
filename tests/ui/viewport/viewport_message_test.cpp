// SPDX-License-Identifier: GPL-3.0-or-later
#include <QLabel>
#include <QTest>

#include "tests/ui/opened.h"
#include "ui/viewport/viewport.h"

using namespace proveout;

class ViewportMessageTest : public QObject {
    Q_OBJECT

private slots:
    void saysWhyThereIsNoPicture();
    void paperModeContinuesWithoutAPicture();
    void knowsSoftwareByName();
};

void ViewportMessageTest::saysWhyThereIsNoPicture() {
    Session session;
    GlSupport support;
    support.reason = QStringLiteral("because");
    const std::unique_ptr<QWidget> view(createViewport(session, support, nullptr));
    auto* label = qobject_cast<QLabel*>(view.get());
    QVERIFY(label != nullptr);
    QCOMPARE(label->text(), support.reason);
}

void ViewportMessageTest::paperModeContinuesWithoutAPicture() {
    Session session;
    const std::unique_ptr<QWidget> view(createViewport(session, GlSupport{}, nullptr));
    QVERIFY(opened(session, QStringLiteral(PROVEOUT_SOURCE_DIR "/resources/samples/core-insert.proveout")));
    QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() != nullptr, 10000);
    session.playback().setSpeed(1e9, true);
    session.playback().play();
    QTRY_VERIFY_WITH_TIMEOUT(session.simulation().block() > 5, 10000);
}

void ViewportMessageTest::knowsSoftwareByName() {
    QVERIFY(isSoftwareRenderer(QStringLiteral("llvmpipe (LLVM 15.0.6, 256 bits)")));
    QVERIFY(isSoftwareRenderer(QStringLiteral("softpipe")));
    QVERIFY(!isSoftwareRenderer(QStringLiteral("NVIDIA GeForce RTX 3060/PCIe/SSE2")));
    QVERIFY(!isSoftwareRenderer(QStringLiteral("Mesa Intel(R) UHD Graphics 620 (KBL GT2)")));
}

QTEST_MAIN(ViewportMessageTest)
#include "viewport_message_test.moc"
