// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict that the session finds in the background, without a window.
#include "ui/session/check_hub.h"

#include <algorithm>
#include <set>
#include <string>

#include <QElapsedTimer>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "core/cutter/cutter.h"
#include "core/verification/findings/check_findings.h"
#include "tests/ui/opened.h"
#include "ui/session/session.h"

namespace proveout {
namespace {

constexpr int kPatience = 30'000; ///< ms

const QByteArray kHead = "G21 G90 G17\nT1 M6\nS1000 M3\nG43 H1\nG0 X5 Y5 Z5\nG1 Z-2 F100\nX10\n";
const QByteArray kEnd = "G0 Z5\nM30\n";

std::set<std::string> everything() {
    std::set<std::string> ids;
    for (const NotCheckedRow& row : notCheckedRows())
        ids.insert(row.id);
    return ids;
}

struct Bench {
    QTemporaryDir folder;
    Session session;

    Bench() { session.check().setAccepted(everything()); }
    CheckHub& hub() { return session.check(); }
    /// Opens a text on a stock of 40 × 30 × 10 mm, with a 4 mm ball-end mill.
    bool open(const QByteArray& text) {
        const QString name = folder.filePath(QStringLiteral("p.nc"));
        QFile file(name);
        const bool written = file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
        file.close();
        return written && opened(session, name) && setUp();
    }
    bool setUp() {
        Setup setup = session.job().setup();
        setup.stock = {};
        setup.stock.width = 40;
        setup.stock.depth = 30;
        setup.stock.height = 10;
        setup.stock.corner = Vec3(0);
        setup.tools.set(1, parseCutter("ball:d=4,l=20").value());
        return session.job().setSetup(setup).has_value();
    }
    bool isChecked() {
        return QTest::qWaitFor([this] { return hub().report() || !hub().refusal().empty(); }, kPatience);
    }
    Verdict verdict() { return hub().report() ? hub().report()->verdict() : Verdict::unverified; }
};

} // namespace

class CheckHubTest : public QObject {
    Q_OBJECT

private slots:
    void aProgramIsCheckedWithoutBeingPlayed() {
        Bench bench;
        QVERIFY(!bench.hub().progress() && !bench.hub().report());
        QVERIFY(bench.open(kHead + "X20\n" + kEnd));
        QVERIFY(bench.hub().progress());
        QVERIFY(bench.isChecked());
        QVERIFY(bench.hub().report());
        QVERIFY(bench.verdict() == Verdict::safe);
        QVERIFY(!bench.hub().progress());
        QCOMPARE(bench.session.simulation().block(), std::size_t{0});
        bench.hub().setAccepted({});
        QVERIFY(bench.verdict() == Verdict::unverified);
    }

    void anEditRemovesTheFault() {
        Bench bench;
        const QByteArray text = kHead + "G0 X20\n" + kEnd;
        QVERIFY(bench.open(text));
        QVERIFY(bench.isChecked());
        QVERIFY(bench.verdict() == Verdict::faults);
        QCOMPARE(bench.hub().report()->faults(), std::size_t{1});
        QCOMPARE(bench.hub().report()->findings.back().diagnostic.where.line, 8);
        const auto place = static_cast<std::size_t>(text.indexOf("G0 X20"));
        bench.session.document().applyEdit(place, 2, "G1");
        QVERIFY2(!bench.hub().report(), "it was of another text");
        QVERIFY(bench.hub().progress());
        QVERIFY(bench.isChecked());
        QVERIFY(bench.verdict() == Verdict::safe);
        QVERIFY(bench.hub().change() == (CheckChange{0, 1}));
        QVERIFY(bench.open(text));
        QVERIFY(bench.isChecked());
        QVERIFY2(!bench.hub().change() || bench.hub().change()->added == 0, "another text is no change");
    }

    void aChangedSetupIsCheckedAgain() {
        Bench bench;
        QVERIFY(bench.open(kHead + "X20\n" + kEnd));
        QVERIFY(bench.isChecked());
        Setup setup = bench.session.job().setup();
        setup.tools.set(1, parseCutter("drill:d=4,angle=118,l=20").value());
        QVERIFY(bench.session.job().setSetup(setup).has_value());
        QVERIFY(!bench.hub().report());
        QVERIFY(bench.isChecked());
        QVERIFY2(bench.verdict() == Verdict::faults, "a drill moves sideways");
    }

    void anUnknownWordLeavesItUnverified() {
        Bench bench;
        QVERIFY(bench.open(kHead + "G987\nX20\n" + kEnd));
        QVERIFY(bench.isChecked());
        QVERIFY(bench.hub().report());
        QVERIFY(bench.verdict() == Verdict::unverified);
    }

    void aStockThatNobodyHasGivenIsListed() {
        Bench bench;
        bench.hub().setAccepted({});
        const QString name = bench.folder.filePath(QStringLiteral("q.nc"));
        QFile file(name);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(kHead + "X20\n" + kEnd) > 0);
        file.close();
        QVERIFY(opened(bench.session, name));
        QVERIFY(bench.isChecked());
        const auto lists = [&](const char* id) {
            return std::ranges::any_of(bench.hub().report()->notChecked, [&](const NotChecked& entry) {
                return std::string(entry.row->id) == id;
            });
        };
        QVERIFY(lists("stock-fitted"));
        QVERIFY(bench.setUp());
        QVERIFY(bench.isChecked());
        QVERIFY(!lists("stock-fitted"));
    }

    void withoutTheMemoryItIsRefused() {
        Bench bench;
        bench.hub().setMemoryLimit(1000);
        QVERIFY(bench.open(kHead + "X20\n" + kEnd));
        QVERIFY(bench.isChecked());
        QVERIFY(!bench.hub().report());
        QVERIFY(hasIdOf(bench.hub().refusal().front(), check_finding::kCheckNeedsMemory));
        bench.hub().setMemoryLimit(1'000'000'000);
        QVERIFY(bench.hub().refusal().empty());
        QVERIFY(bench.isChecked());
        QVERIFY(bench.verdict() == Verdict::safe);
    }

    void aTextOfAnotherControlIsRefused() {
        Bench bench;
        QVERIFY(bench.open("%_N_SINUMERIK840D_POCKET_MPF\n;$PATH=/_N_WKS_DIR/_N_TEST_WPD\n"
                           "N10 T=\"MILL10\" M6\nN20 CYCLE832(0.05,1)\nN30 G0 X0 Y0 Z5\nN40 M30\n"));
        QVERIFY(bench.isChecked());
        QVERIFY(!bench.hub().report());
        QCOMPARE(bench.hub().refusal().front().id, "dialect-foreign");
    }

    /// Of a long program of a wide cutter on a fine grid.
    void otherProgramsAndTheEndCancelIt() {
        QElapsedTimer closing;
        {
            Bench bench;
            QByteArray text = kHead;
            for (int i = 0; i < 20'000; ++i)
                text += i % 2 == 0 ? "X35 Y25\n" : "X5 Y5\n";
            QVERIFY(bench.open(text + kEnd));
            Setup setup = bench.session.job().setup();
            setup.automaticGrid = false;
            setup.spacing = 0.1; // finer, ThreadSanitizer takes too long to the first per cent
            setup.tools.set(1, parseCutter("ball:d=30,l=40").value());
            QVERIFY(bench.session.job().setSetup(setup).has_value());
            QTRY_VERIFY_WITH_TIMEOUT(bench.hub().progress().value_or(0) > 0, kPatience);
            bench.session.document().newFile();
            QSignalSpy progressed(&bench.hub(), &CheckHub::progressed);
            QVERIFY(!bench.hub().report());
            QVERIFY(bench.isChecked());
            QVERIFY2(bench.hub().report()->programUnverified, "an empty program, not the one before");
            QVERIFY(bench.open(text + kEnd));
            QVERIFY(bench.session.job().setSetup(setup).has_value());
            QTRY_VERIFY_WITH_TIMEOUT(bench.hub().progress().value_or(0) > 0, kPatience);
            closing.start();
        }
        QVERIFY2(closing.elapsed() < 2000, qPrintable(QString::number(closing.elapsed())));
    }

    void itCanBeTurnedOff() {
        Bench bench;
        bench.hub().setOn(false);
        QVERIFY(bench.open(kHead + "X20\n" + kEnd));
        QTest::qWait(1000);
        QVERIFY(!bench.hub().report() && !bench.hub().progress() && bench.hub().refusal().empty());
        bench.hub().setOn(true);
        QVERIFY(bench.isChecked());
        QVERIFY(bench.verdict() == Verdict::safe);
    }
};

} // namespace proveout

QTEST_MAIN(proveout::CheckHubTest)
#include "check_hub_test.moc"
