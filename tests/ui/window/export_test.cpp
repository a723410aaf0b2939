// SPDX-License-Identifier: GPL-3.0-or-later
// Export from the window: its dialog reads the table of formats, and every format is written and told.
#include <algorithm>
#include <functional>
#include <memory>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "core/base/atomic_file.h"
#include "core/formats/formats.h"
#include "tests/ui/window/workstation.h"
#include "ui/diagnostic_text.h"
#include "ui/file_paths.h"

namespace proveout {
namespace {

std::vector<const FileFormat*> meshFormats() {
    std::vector<const FileFormat*> out;
    for (const FileFormat& format : fileFormats())
        if (format.meshWriter() != nullptr)
            out.push_back(&format);
    return out;
}

QLineEdit& nameOf(QFileDialog& dialog) {
    return *dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
}

/// As a user does: from the first filter downwards by the keyboard.
void chooseFilter(QFileDialog& dialog, int row) {
    auto* filters = dialog.findChild<QComboBox*>(QStringLiteral("fileTypeCombo"));
    for (int i = 0; i < row; ++i)
        QTest::keyClick(filters, Qt::Key_Down);
}

void save(QFileDialog& dialog) {
    dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save)->click();
}

/// Triggers an action that opens a file dialog, and lets `work` deal with it.
void inDialog(MainWindow& window, const char* action, const std::function<void(QFileDialog&)>& work) {
    bool met = false;
    QTimer wait;
    QObject::connect(&wait, &QTimer::timeout, [&] {
        auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        if (dialog == nullptr || met)
            return;
        met = true;
        work(*dialog);
    });
    wait.start(20);
    window.action(QLatin1String(action))->trigger();
    QVERIFY(met);
}

} // namespace

class ExportTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs); }
    void init() { m_settings = std::make_unique<OwnSettings>(); }

    void theDialogOffersTheFormatsOfTheTable() {
        Workstation station(true);
        inDialog(station.window, "export-mesh", [](QFileDialog& dialog) {
            QCOMPARE(dialog.nameFilters().size(), static_cast<qsizetype>(meshFormats().size()));
            for (std::size_t row = 0; row < meshFormats().size(); ++row) {
                const QString filter = dialog.nameFilters().at(static_cast<qsizetype>(row));
                QVERIFY(filter.contains(coreText(meshFormats()[row]->label)));
                QVERIFY(filter.contains(QLatin1String(meshFormats()[row]->extensions.front())));
            }
            QCOMPARE(nameOf(dialog).text(), QStringLiteral("core-insert.stl"));
            dialog.reject();
        });
        QVERIFY(!station.session.work());
    }

    void everyFormatIsWritten_data() {
        QTest::addColumn<int>("row");
        QTest::addColumn<QByteArray>("begins");
        QTest::addRow("stl") << 0 << QByteArray("Proveout, binary STL");
        QTest::addRow("stl-ascii") << 1 << QByteArray("solid proveout");
        QTest::addRow("obj") << 2 << QByteArray("# Proveout, mm\nv ");
        QTest::addRow("ply") << 3 << QByteArray("ply\nformat binary_little_endian 1.0\n");
        QTest::addRow("3mf") << 4 << QByteArray("PK\3\4");
    }

    void everyFormatIsWritten() {
        QFETCH(int, row);
        QFETCH(QByteArray, begins);
        const FileFormat& format = *meshFormats().at(static_cast<std::size_t>(row));
        QCOMPARE(QTest::currentDataTag(), format.key);
        QCOMPARE(meshFormats().size(), std::size_t{5}); // a new format belongs into the table above
        QTemporaryDir folder;
        Workstation station(true);
        QSignalSpy exported(&station.session, &Session::exported);
        const QString wanted =
            folder.filePath(QStringLiteral("part") + QLatin1String(format.extensions.front()));
        inDialog(station.window, "export-mesh", [&](QFileDialog& dialog) {
            nameOf(dialog).setText(folder.filePath(QStringLiteral("part.stl")));
            chooseFilter(dialog, row);
            save(dialog);
        });
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, kPatience);
        const ExportSummary& summary = *station.session.lastExport();
        QCOMPARE(summary.file, wanted);
        QCOMPARE(static_cast<qint64>(summary.bytes), QFileInfo(wanted).size());
        QVERIFY(summary.triangles > 0);
        const auto bytes = readFile(toPath(wanted));
        QVERIFY(bytes.has_value());
        QVERIFY(QByteArray::fromStdString(bytes->substr(0, 100)).startsWith(begins));
        const QString told = station.window.statusBar()->currentMessage();
        for (const QString& part : {wanted, QLocale().toString(static_cast<qulonglong>(summary.triangles)),
                                    QLocale().toString(summary.largestErrorMm, 'f', 4)})
            QVERIFY2(told.contains(part), qPrintable(told));
    }

    void anEndingThatIsTypedOutranksTheFilter() {
        QTemporaryDir folder;
        Workstation station(true);
        QSignalSpy exported(&station.session, &Session::exported);
        inDialog(station.window, "export-full-mesh", [&](QFileDialog& dialog) {
            nameOf(dialog).setText(folder.filePath(QStringLiteral("part.PLY")));
            save(dialog);
        });
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, kPatience);
        QVERIFY(readFile(toPath(folder.filePath(QStringLiteral("part.PLY"))))->starts_with("ply\n"));
        QCOMPARE(station.session.lastExport()->largestErrorMm, 0.0); // in double, with every point
    }

    void aNameWithoutAnEndingGetsThatOfTheFilter() {
        QTemporaryDir folder;
        Workstation station(true);
        QSignalSpy exported(&station.session, &Session::exported);
        inDialog(station.window, "export-mesh", [&](QFileDialog& dialog) {
            chooseFilter(dialog, 2);
            nameOf(dialog).setText(folder.filePath(QStringLiteral("part")));
            save(dialog);
        });
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, kPatience);
        QVERIFY(QFileInfo::exists(folder.filePath(QStringLiteral("part.obj"))));
    }

    /// Where steps of float32 are 1/32 mm, an STL cannot keep what the mesh keeps.
    void roundingBeyondTheAllowanceIsAProblemThatOffersDoubles() {
        QTemporaryDir folder;
        const QString program = folder.filePath(QStringLiteral("far.nc"));
        QVERIFY(writeFile(toPath(program), "T1 M6\nG0 X500005 Y5 Z5\nG1 Z-2 F100\nX500030\nG0 Z5\nM30\n"));
        Workstation station(false);
        station.open(program);
        Setup setup = station.session.setup();
        setup.stock = {{500000.013, 0, 0}, 40, 30, 10};
        setup.spacing = 0.5;
        setup.tools.set(1, parseCutter("ball:d=4,l=20").value());
        QVERIFY(station.session.setSetup(setup));
        station.session.seek(station.session.blockCount());
        QTRY_VERIFY_WITH_TIMEOUT(station.session.frame() && station.session.block() == 4, kPatience);
        QSignalSpy exported(&station.session, &Session::exported);
        const auto warned = [&] {
            return std::ranges::any_of(station.session.problems(), [](const Diagnostic& problem) {
                return QByteArray(problem.id) == "export-rounded-beyond";
            });
        };
        station.session.exportMesh(folder.filePath(QStringLiteral("far.obj")), {});
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, kPatience);
        QVERIFY(!warned());
        QVERIFY(station.session.lastExport()->largestErrorMm <= station.session.parameters().allowance);
        station.session.exportMesh(folder.filePath(QStringLiteral("far.stl")), {});
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 2, kPatience);
        QVERIFY(warned());
        QVERIFY(station.session.lastExport()->largestErrorMm > station.session.parameters().allowance);
    }

private:
    std::unique_ptr<OwnSettings> m_settings;
};

} // namespace proveout

QTEST_MAIN(proveout::ExportTest)
#include "export_test.moc"
