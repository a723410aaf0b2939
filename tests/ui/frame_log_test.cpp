// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <QTest>

#include "ui/program/frame_log.h"

namespace proveout {
namespace {

/// A frame after `block` of 100 blocks, each of which took 1 ms.
Frame frameAt(std::size_t block, std::uint64_t sequence) {
    Frame frame;
    frame.block = block;
    frame.sequence = sequence;
    for (int k = 0; k < 100; ++k) {
        BlockStatistics row;
        row.cutSeconds = 0.001f;
        frame.statistics.push_back(row);
    }
    return frame;
}

} // namespace

class FrameLogTest : public QObject {
    Q_OBJECT

private slots:
    void goingBackCutsOffWhatIsBehind() {
        FrameLog log;
        QVERIFY(log.add(frameAt(10, 1), 0, 0.010));
        QVERIFY(log.add(frameAt(50, 2), 0, 0.040));
        QVERIFY(!log.add(frameAt(50, 2), 0, 0.040)); // painted again
        QVERIFY(log.add(frameAt(20, 3), 0, 0.010));  // within the second row
        QCOMPARE(log.rows().size(), std::size_t{2});
        const FrameStatistics& cut = log.rows().back();
        QCOMPARE(cut.firstBlock, 10U);
        QCOMPARE(cut.lastBlock, 20U);
        QVERIFY(std::abs(cut.cutSeconds - 0.010f) < 1e-6f); // the mean per block is unchanged
        QVERIFY(std::abs(cut.drawSeconds - 0.010f) < 1e-6f);
        QVERIFY(log.add(frameAt(30, 4), 0, 0.010));
        std::uint32_t reached = 0;
        for (const FrameStatistics& row : log.rows()) { // no block is missing
            QCOMPARE(row.firstBlock, reached);
            reached = row.lastBlock;
        }
        QCOMPARE(reached, 30U);
        QVERIFY(log.add(frameAt(0, 5), 0, 0));
        QVERIFY(log.rows().empty());
    }
};

} // namespace proveout

QTEST_MAIN(proveout::FrameLogTest)
#include "frame_log_test.moc"
