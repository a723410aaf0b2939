// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/program/program_index.h"

#include <string>

#include <QTest>

#include "core/nc/run/interpreter.h"

namespace proveout {
namespace {

StockBox stockOf(const std::string& text) {
    return fittedStock(cuttingExtent(*interpret(NcText(text))), {}, {});
}

} // namespace

class ProgramIndexTest : public QObject {
    Q_OBJECT

private slots:
    void theStockHasItsTopAtTheWorkZero_data() {
        QTest::addColumn<QByteArray>("before");
        QTest::addColumn<double>("zero");
        QTest::newRow("no offset") << QByteArray() << 0.0;
        QTest::newRow("G10 L2") << QByteArray("G10 L2 P1 X-269.39 Y-254.65 Z-689.\n") << -689.0;
        QTest::newRow("G10 L2, not whole") << QByteArray("G10 L2 P1 Z-688.75\n") << -688.75;
        QTest::newRow("G54 after G10") << QByteArray("G10 L2 P1 Z-30\nG54\n") << -30.0;
        QTest::newRow("G55 by its variable") << QByteArray("#5243=-120\nG55\n") << -120.0;
        QTest::newRow("G55") << QByteArray("G10 L2 P2 Z40\nG55\n") << 40.0;
        QTest::newRow("G92") << QByteArray("G0 Z100\nG92 Z10\n") << 90.0;
    }
    void theStockHasItsTopAtTheWorkZero() {
        QFETCH(QByteArray, before);
        QFETCH(double, zero);
        const StockBox stock =
            stockOf("G21 G90 G17\n" + before.toStdString() + "G0 X0 Y0 Z5\nG1 Z-15 F100\nX20\nG0 Z5\nM2\n");
        QCOMPARE(stock.topZ(), zero);
        QCOMPARE(stock.height, 20.0); // 15 mm of cut and 5 mm below it
    }

    void theStockOfSeveralOffsetsHasItsTopAtTheHighest() {
        // The second part of the program runs again at a lower level, and then returns.
        const StockBox stock =
            stockOf("G21 G90 G17\nG10 L2 P1 Z-50\nG10 L2 P2 Z-60\n"
                    "G54 G0 X0 Y0 Z5\nG1 Z2 F100\nX20\nG55\nG1 Z-3\nX0\nG54\nG1 Z-1\nX20\nM2\n");
        QCOMPARE(stock.topZ(), -50.0);
        QCOMPARE(stock.height, 18.0);
    }

    void theStockOfWhatIsAllAboveTheZeroReachesUpToIt() {
        // For setups with Z0 at the table.
        const StockBox stock =
            stockOf("G21 G90 G17\nG10 L2 P1 Z-100\nG0 X0 Y0 Z50\nG1 Z19.5 F100\nX20\nZ12\nX0\nM2\n");
        QCOMPARE(stock.topZ(), -50.0);
        QCOMPARE(stock.height, 43.0); // down to 12 mm above Z0 of the offset, and 5 mm below that
    }
};

} // namespace proveout

QTEST_GUILESS_MAIN(proveout::ProgramIndexTest)
#include "program_index_test.moc"
