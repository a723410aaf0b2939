// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/codes/dialects.h"
#include "ui/setup/setup_panel.h"

#include <algorithm>
#include <set>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "tests/ui/opened.h"

namespace proveout {
namespace {

constexpr int kPatience = 10'000; ///< ms

/// Type B uses one motion more around the first corner.
const char* const kCompensated = "G90 G1 G42 D1 X0 Y0 F100\nX-20. Y20.\nG40 X0\nM30\n";

QString write(const QTemporaryDir& folder, const QByteArray& text) {
    const QString name = folder.filePath(QStringLiteral("p.nc"));
    QFile file(name);
    const bool written = file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
    return written ? name : QString();
}

QComboBox& compensation(const SetupPanel& panel) {
    return *panel.findChild<QComboBox*>(QStringLiteral("compensation-start"));
}

bool isOffered(const SetupPanel& panel) {
    return compensation(panel).isVisibleTo(&panel);
}

Result<void> setDialect(Session& session, std::optional<DialectId> dialect) {
    Setup setup = session.job().setup();
    setup.dialect = dialect;
    setup.start = Vec3(-20, 0, 0);
    setup.tools.set(1, parseCutter("flat:d=10").value());
    return session.job().setSetup(setup);
}

} // namespace

class SetupPanelTest : public QObject {
    Q_OBJECT

private slots:
    void theStockTakesItsShapeAndItsPlace() {
        QTemporaryDir folder;
        Session session;
        SetupPanel panel(session);
        QVERIFY(opened(session, write(folder, kCompensated)));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame(), kPatience); // the stock is fitted by then
        auto* shape = panel.findChild<QComboBox*>(QStringLiteral("stock-shape"));
        auto* diameter = panel.findChild<QDoubleSpinBox*>(QStringLiteral("stock-cylinder-diameter"));
        QVERIFY(diameter->isHidden());
        const Vec3 corner = session.job().setup().stock.corner;
        shape->setCurrentIndex(1);
        QVERIFY(!diameter->isHidden());
        diameter->setValue(42);
        QTRY_COMPARE_WITH_TIMEOUT(session.job().setup().shape.kind, StockKind::cylinder, kPatience);
        QTRY_COMPARE_WITH_TIMEOUT(session.job().setup().stock.depth, 42.0, kPatience);
        QVERIFY(session.job().setup().shape.body != nullptr);
        QVERIFY(session.job().setup().stock.corner == corner);
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame() &&
                                     session.simulation().frame()->zmap.stock().width == 42 &&
                                     session.simulation().frame()->zmap.height(0, 0) < 0,
                                 kPatience);
        const QString job = folder.filePath(QStringLiteral("p.proveout"));
        QVERIFY(session.document().saveJobAs(job));

        // The remaining stock becomes the stock of the next setup, in the same position and on its grid.
        const QString stock = folder.filePath(QStringLiteral("a.pvstock"));
        QSignalSpy saved(&session.exports(), &ExportHub::exported);
        session.exports().saveStock(stock);
        QTRY_COMPARE_WITH_TIMEOUT(saved.size(), 1, kPatience);
        auto* file = panel.findChild<QLineEdit*>(QStringLiteral("stock-file-file"));
        shape->setCurrentIndex(4);
        file->setText(stock);
        emit file->editingFinished();
        QTRY_COMPARE_WITH_TIMEOUT(session.job().setup().shape.kind, StockKind::saved, kPatience);
        QVERIFY(session.job().setup().stock.corner == corner);
        QCOMPARE(session.job().setup().stock.width, 42.0);
        // A missing file is reported and changes nothing.
        file->setText(folder.filePath(QStringLiteral("none.pvstock")));
        emit file->editingFinished();
        const auto reported = [&panel] {
            const auto labels = panel.findChildren<QLabel*>();
            return std::ranges::any_of(labels, [](const QLabel* label) {
                return label->text().contains(QStringLiteral("cannot be read"));
            });
        };
        QTRY_VERIFY_WITH_TIMEOUT(reported(), kPatience);
        QCOMPARE(session.job().setup().stock.width, 42.0);

        Session other;
        QVERIFY(opened(other, job));
        QCOMPARE(other.job().setup().shape.kind, StockKind::cylinder);
        QCOMPARE(other.job().setup().stock.width, 42.0);
    }

    void aToolThatIsAskedForIsSeenAndReadyToBeTyped() {
        QTemporaryDir folder;
        Session session;
        SetupPanel panel(session);
        panel.resize(320, 300);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        QVERIFY(opened(session, write(folder, "G21\nT7 M6\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX9\nM30\n")));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame(), kPatience);
        emit session.navigation().toolRequested(7);
        const auto diameter = [&panel] { return panel.findChild<QDoubleSpinBox*>(QStringLiteral("tool-d")); };
        QTRY_VERIFY_WITH_TIMEOUT(diameter() != nullptr && !diameter()->visibleRegion().isEmpty(), kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(session.job().setup().tools.unconfirmedOrigin(7) != nullptr, kPatience);
        QCOMPARE(session.job().setup().tools.unconfirmedOrigin(7)->source, ToolSource::assumed);
    }

    void theStartOfCompensationIsChosenAndSavedWithTheJob() {
        QTemporaryDir folder;
        Session session;
        SetupPanel panel(session);
        QVERIFY(opened(session, write(folder, kCompensated)));
        QVERIFY(setDialect(session, DialectId::fanuc).has_value());
        const auto motions = [&session] {
            return session.program().current() ? session.program().current()->motionCount() : 0;
        };
        QTRY_COMPARE_WITH_TIMEOUT(motions(), std::size_t{3}, kPatience);
        const QString job = folder.filePath(QStringLiteral("p.proveout"));
        QVERIFY(session.document().saveJobAs(job));
        QVERIFY(!session.document().modified());

        QVERIFY(isOffered(panel));
        QTest::keyClick(&compensation(panel), Qt::Key_Down);
        QTRY_COMPARE_WITH_TIMEOUT(motions(), std::size_t{4}, kPatience);
        QVERIFY(session.job().setup().compensationTypeB);
        QVERIFY(session.document().modified());
        QVERIFY(session.document().save());
        QVERIFY(!session.document().modified());

        Session other;
        SetupPanel shown(other);
        QCOMPARE(compensation(shown).currentIndex(), 0);
        QVERIFY(opened(other, job));
        QCOMPARE(compensation(shown).currentIndex(), 1);
        other.document().newFile();
        QCOMPARE(compensation(shown).currentIndex(), 0);
    }

    void mCodesAreAddedToTheIgnoredOnes() {
        QTemporaryDir folder;
        Session session;
        SetupPanel panel(session);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        auto* list = panel.findChild<QLineEdit*>(QStringLiteral("ignored-m"));
        auto* found = panel.findChild<QLabel*>(QStringLiteral("ignored-m-found"));
        auto* problem = panel.findChild<QLabel*>(QStringLiteral("ignored-m-problem"));
        QVERIFY(opened(session, write(folder, "%\nO1\nG65 P2\nM10\nM16\nM30\nO2\nM99\n%\n")));
        QTRY_VERIFY_WITH_TIMEOUT(session.program().current() && session.program().current()->unverified(),
                                 kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(found->isVisibleTo(&panel), kPatience);
        QVERIFY(found->text().contains(QLatin1String("M10")));
        QVERIFY(!found->text().contains(QLatin1String("M16")));

        list->setFocus();
        QTest::keyClicks(list, QStringLiteral("1x"));
        QTest::keyClick(list, Qt::Key_Return);
        QVERIFY(problem->isVisibleTo(&panel));
        QVERIFY(session.job().setup().ignoredM.empty());
        list->selectAll();
        QTest::keyClicks(list, QStringLiteral("M16 24"));
        QTest::keyClick(list, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(session.job().setup().ignoredM, (std::set<int>{16, 24}), kPatience);
        QVERIFY(!problem->isVisibleTo(&panel));
        QCOMPARE(list->text(), QStringLiteral("16, 24"));
        QTRY_VERIFY_WITH_TIMEOUT(found->text().contains(QLatin1String("M16")), kPatience);
        QVERIFY(session.document().jobModified());
        const QString job = folder.filePath(QStringLiteral("p.proveout"));
        QVERIFY(session.document().saveJobAs(job));

        Session other;
        SetupPanel shown(other);
        QVERIFY(opened(other, job));
        QCOMPARE(shown.findChild<QLineEdit*>(QStringLiteral("ignored-m"))->text(), QStringLiteral("16, 24"));
        other.document().newFile();
        QVERIFY(shown.findChild<QLineEdit*>(QStringLiteral("ignored-m"))->text().isEmpty());
    }

    void aProgramOfAnotherControlHasNoDialectOfOurs() {
        QTemporaryDir folder;
        Session session;
        SetupPanel panel(session);
        QVERIFY(opened(session, write(folder, "0 BEGIN PGM A MM\n1 L X+1 R0 FMAX\n2 END PGM A MM\n")));
        QTRY_VERIFY_WITH_TIMEOUT(
            session.program().current() && session.program().current()->foreignKind() != nullptr, kPatience);
        QCOMPARE(session.problems().all().size(), std::size_t{1});
        auto* dialects = panel.findChild<QComboBox*>(QStringLiteral("dialect"));
        QVERIFY(dialects->currentText().contains(QLatin1String("none")));
        // Choosing a dialect makes it read the text.
        QVERIFY(setDialect(session, DialectId::fanuc).has_value());
        QTRY_VERIFY_WITH_TIMEOUT(session.program().current()->foreignKind() == nullptr, kPatience);
        QVERIFY(session.problems().all().size() > 1);
    }

    void theStartOfCompensationIsOfferedWhereTheControlHasIt() {
        QTemporaryDir folder;
        Session session;
        SetupPanel panel(session);
        QVERIFY(!isOffered(panel));
        for (const Dialect& row : dialects()) {
            QVERIFY(setDialect(session, row.id).has_value());
            QCOMPARE(isOffered(panel), row.vectors.used);
        }
        // A dialect that was not set is known once the text is interpreted.
        QVERIFY(opened(session, write(folder, "O1\nG65 P2 X5.\nM30\nO2\nM99\n")));
        QVERIFY(!session.job().setup().dialect);
        QTRY_VERIFY_WITH_TIMEOUT(isOffered(panel), kPatience);
        session.document().applyEdit(0, session.document().text().text.size(), "o<a> sub\no<a> endsub\nM2\n");
        QTRY_VERIFY_WITH_TIMEOUT(!isOffered(panel), kPatience);
    }
};

} // namespace proveout

QTEST_MAIN(proveout::SetupPanelTest)
#include "setup_panel_test.moc"
