// SPDX-License-Identifier: GPL-3.0-or-later
// Export from the window: its dialog uses the table of formats, and every format is written and reported.
#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
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
#include "ui/document/file_paths.h"
#include "ui/files/run_to_end.h"
#include "ui/look/diagnostic_text.h"

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

/// Selects by keyboard, as a user does, from the first filter downwards.
void chooseFilter(QFileDialog& dialog, int row) {
    auto* filters = dialog.findChild<QComboBox*>(QStringLiteral("fileTypeCombo"));
    for (int i = 0; i < row; ++i)
        QTest::keyClick(filters, Qt::Key_Down);
}

void save(QFileDialog& dialog) {
    dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save)->click();
}

/// Passes the next dialog of this type to `work` once it is open.
template<class Dialog>
void whenOpen(const std::function<void(Dialog&)>& work) {
    auto* wait = new QTimer(qApp);
    QObject::connect(wait, &QTimer::timeout, [wait, work] {
        if (auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget())) {
            wait->stop();
            wait->deleteLater();
            work(*dialog);
        }
    });
    wait->start(20);
}

/// Cancels the next run to the end before a frame of it can arrive: stock that was cut before is kept, so
/// that the run may end at once.
class CancelledRun final : public QObject {
public:
    CancelledRun() { qApp->installEventFilter(this); }

    [[nodiscard]] bool eventFilter(QObject* watched, QEvent* event) override {
        if (auto* dialog = qobject_cast<RunToEnd*>(watched);
            dialog != nullptr && event->type() == QEvent::Show)
            QTimer::singleShot(0, dialog, [dialog] {
                dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Cancel)->click();
            });
        return false;
    }
};

void press(QMessageBox& question, const QString& name) {
    for (QAbstractButton* each : question.buttons())
        if (each->text().remove(u'&') == name)
            return each->click();
    qFatal("no button %s", qPrintable(name));
}

/// Triggers an action that opens a file dialog, and passes it to `work`. A program that has not run to its
/// end is exported at its current block.
void inDialog(MainWindow& window, const char* action, const std::function<void(QFileDialog&)>& work) {
    bool met = false;
    whenOpen<QFileDialog>([&](QFileDialog& dialog) {
        met = true;
        work(dialog);
    });
    if (isHalfRun(window.session()))
        whenOpen<QMessageBox>(
            [](QMessageBox& question) { press(question, QStringLiteral("Use Stock as Is")); });
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
        QVERIFY(!station.session.work().current());
    }

    void everyFormatIsWritten_data() {
        QTest::addColumn<int>("row");
        QTest::addColumn<QByteArray>("begins");
        QTest::addRow("stl") << 0 << QByteArray("Proveout, binary STL");
        QTest::addRow("stl-ascii") << 1 << QByteArray("solid proveout");
        QTest::addRow("obj") << 2 << QByteArray("# Proveout, mm\nv ");
        QTest::addRow("ply") << 3 << QByteArray("ply\nformat binary_little_endian 1.0\n");
        QTest::addRow("3mf") << 4 << QByteArray("PK\3\4");
        QTest::addRow("glb") << 5 << QByteArray("glTF\2");
    }

    void everyFormatIsWritten() {
        QFETCH(int, row);
        QFETCH(QByteArray, begins);
        const FileFormat& format = *meshFormats().at(static_cast<std::size_t>(row));
        QCOMPARE(QTest::currentDataTag(), format.key);
        QCOMPARE(meshFormats().size(), std::size_t{6}); // add a new format to the table above
        QTemporaryDir folder;
        Workstation station(true);
        QSignalSpy exported(&station.session.exports(), &ExportHub::exported);
        const QString wanted =
            folder.filePath(QStringLiteral("part") + QLatin1String(format.extensions.front()));
        inDialog(station.window, "export-mesh", [&](QFileDialog& dialog) {
            nameOf(dialog).setText(folder.filePath(QStringLiteral("part.stl")));
            chooseFilter(dialog, row);
            save(dialog);
        });
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, kPatience);
        const ExportSummary& summary = *station.session.exports().last();
        QCOMPARE(summary.file, wanted);
        QCOMPARE(static_cast<qint64>(summary.bytes), QFileInfo(wanted).size());
        QVERIFY(summary.triangles > 0);
        const auto bytes = readFile(toPath(wanted));
        QVERIFY(bytes.has_value());
        QVERIFY(QByteArray::fromStdString(bytes->substr(0, 100)).startsWith(begins));
        const QString reported = station.window.statusBar()->currentMessage();
        for (const QString& part :
             {QFileInfo(wanted).fileName(), QLocale().toString(summary.largestErrorMm, 'f', 6)})
            QVERIFY2(reported.contains(part), qPrintable(reported));
        const QString more = station.window.statusBar()->toolTip();
        for (const QString& part : {wanted, QLocale().toString(static_cast<qulonglong>(summary.triangles))})
            QVERIFY2(more.contains(part), qPrintable(more));
    }

    void theMessageSaysWhatTheErrorIsWorth() {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("part.ply"));
        Workstation station(true);
        const auto reportedAfter = [&](const ExportOptions& options) {
            QSignalSpy exported(&station.session.exports(), &ExportHub::exported);
            station.session.exports().exportMesh(file, options);
            return QTest::qWaitFor([&] { return exported.count() == 1; }, kPatience)
                       ? station.window.statusBar()->currentMessage()
                       : QString();
        };
        DecimationParameters parameters = station.session.job().parameters();
        parameters.allowance = 0.0325;
        station.session.job().setParameters(parameters);
        QTRY_COMPARE_WITH_TIMEOUT(station.session.simulation().frame()->parameters, parameters, kPatience);
        QVERIFY(reportedAfter({}).endsWith(QLatin1String("certified within 0.0325 mm everywhere")));
        QVERIFY(reportedAfter({false}).contains(QLatin1String("full resolution, largest error 0")));
        const auto reportedWith = [&] {
            station.session.job().setParameters(parameters);
            const bool taken = QTest::qWaitFor(
                [&] { return station.session.simulation().frame()->parameters == parameters; }, kPatience);
            return taken ? reportedAfter({}) : QString();
        };
        parameters.level = ErrorLevel::sample;
        QVERIFY(reportedWith().endsWith(QLatin1String("certified within 0.0325 mm at every z-map point")));
        parameters.method = DecimationMethod::lee;
        QVERIFY(reportedWith().endsWith(QLatin1String("certified within 0.0325 mm at every z-map point")));
        parameters.certify = false;
        QVERIFY(reportedWith().endsWith(QLatin1String("mm, not guaranteed")));
    }

    void aHalfRunProgramIsNamedAsSuch() {
        QTemporaryDir folder;
        Workstation station(true);
        Session& session = station.session;
        session.playback().seek(3);
        QTRY_COMPARE_WITH_TIMEOUT(session.simulation().block(), std::size_t{3}, kPatience);
        const QString of = QStringLiteral("3 of %1").arg(session.program().blockCount());
        QString asked;
        QString title;
        whenOpen<QMessageBox>([&](QMessageBox& question) {
            asked = question.text();
            press(question, QStringLiteral("Use Stock as Is"));
            whenOpen<QFileDialog>([&](QFileDialog& dialog) {
                title = dialog.windowTitle();
                nameOf(dialog).setText(folder.filePath(QStringLiteral("part.stl")));
                save(dialog);
            });
        });
        QSignalSpy exported(&session.exports(), &ExportHub::exported);
        station.window.action(QStringLiteral("export-mesh"))->trigger();
        QVERIFY2(asked.contains(of), qPrintable(asked));
        QVERIFY2(title.contains(of), qPrintable(title));
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, kPatience);
        QCOMPARE(session.exports().last()->block, std::size_t{3});
        const QString reported = station.window.statusBar()->currentMessage();
        QVERIFY2(reported.contains(of), qPrintable(reported));
        // A message about an earlier document disappears when another one is opened.
        session.document().newFile();
        QTRY_VERIFY_WITH_TIMEOUT(station.window.statusBar()->currentMessage() != reported, kPatience);
    }

    void aHalfRunProgramCanBeRunToItsEndFirst_data() {
        QTest::addColumn<QString>("action");
        QTest::addColumn<QString>("file");
        QTest::addRow("mesh") << QStringLiteral("export-mesh") << QStringLiteral("part.stl");
        QTest::addRow("stock") << QStringLiteral("file-save-stock") << QStringLiteral("part.pvstock");
    }

    void aHalfRunProgramCanBeRunToItsEndFirst() {
        QFETCH(QString, action);
        QFETCH(QString, file);
        QTemporaryDir folder;
        Workstation station(true);
        Session& session = station.session;
        session.playback().seek(3);
        QTRY_COMPARE_WITH_TIMEOUT(session.simulation().block(), std::size_t{3}, kPatience);
        whenOpen<QMessageBox>([&](QMessageBox& question) {
            press(question, QStringLiteral("Run to the End First"));
            whenOpen<QFileDialog>([&](QFileDialog& dialog) {
                nameOf(dialog).setText(folder.filePath(file));
                save(dialog);
            });
        });
        QSignalSpy exported(&session.exports(), &ExportHub::exported);
        station.window.action(action)->trigger();
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, kPatience);
        QCOMPARE(session.simulation().block(), session.program().blockCount());
        QCOMPARE(session.exports().last()->block, session.program().blockCount());
        QVERIFY(!station.window.statusBar()->currentMessage().contains(QLatin1String(" of ")));
        QVERIFY(QFileInfo::exists(folder.filePath(file)));
    }

    void runningToTheEndCanBeCancelled() {
        Workstation station(true);
        Session& session = station.session;
        Setup setup = session.job().setup();
        setup.spacing = 0.1; // takes seconds
        QVERIFY(session.job().setSetup(setup));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame()->zmap.grid().nx > 1000, kPatience);
        session.playback().seek(0);
        QTRY_COMPARE_WITH_TIMEOUT(session.simulation().block(), std::size_t{0}, kPatience);
        whenOpen<QMessageBox>(
            [&](QMessageBox& question) { press(question, QStringLiteral("Run to the End First")); });
        const CancelledRun cancelled;
        QSignalSpy exported(&session.exports(), &ExportHub::exported);
        station.window.action(QStringLiteral("export-mesh"))->trigger();
        QVERIFY(isHalfRun(session));
        QVERIFY(!session.exports().isRunning());
        QCOMPARE(exported.count(), 0);
    }

    void anEndingThatIsTypedOutranksTheFilter() {
        QTemporaryDir folder;
        Workstation station(true);
        QSignalSpy exported(&station.session.exports(), &ExportHub::exported);
        inDialog(station.window, "export-full-mesh", [&](QFileDialog& dialog) {
            nameOf(dialog).setText(folder.filePath(QStringLiteral("part.PLY")));
            save(dialog);
        });
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, kPatience);
        QVERIFY(readFile(toPath(folder.filePath(QStringLiteral("part.PLY"))))->starts_with("ply\n"));
        QCOMPARE(station.session.exports().last()->largestErrorMm, 0.0); // in double, with all points
    }

    void aNameWithoutAnEndingGetsThatOfTheFilter() {
        QTemporaryDir folder;
        Workstation station(true);
        QSignalSpy exported(&station.session.exports(), &ExportHub::exported);
        inDialog(station.window, "export-mesh", [&](QFileDialog& dialog) {
            chooseFilter(dialog, 2);
            nameOf(dialog).setText(folder.filePath(QStringLiteral("part")));
            save(dialog);
        });
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, kPatience);
        QVERIFY(QFileInfo::exists(folder.filePath(QStringLiteral("part.obj"))));
    }

    /// An extension of no mesh format is part of the name, so a mesh cannot overwrite a program.
    void anyOtherEndingStaysPartOfTheName() {
        QTemporaryDir folder;
        Workstation station(true);
        int done = 0;
        for (const auto& [typed, written] :
             {std::pair{"Hülse 1.5", "Hülse 1.5.stl"}, {"part.nc", "part.nc.stl"}, {"금형.", "금형.stl"}}) {
            QSignalSpy exported(&station.session.exports(), &ExportHub::exported);
            inDialog(station.window, "export-mesh", [&, name = typed](QFileDialog& dialog) {
                nameOf(dialog).setText(folder.filePath(QString::fromUtf8(name)));
                save(dialog);
            });
            QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, kPatience);
            QVERIFY(QFileInfo::exists(folder.filePath(QString::fromUtf8(written))));
            QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), ++done);
        }
    }

    void aFileIsReplacedOnlyWhereTheUserSaysSo() {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("part.stl"));
        for (const bool replace : {false, true}) {
            QVERIFY(writeFile(toPath(file), "mine"));
            Workstation station(true);
            QSignalSpy exported(&station.session.exports(), &ExportHub::exported);
            inDialog(station.window, "export-mesh", [&](QFileDialog& dialog) {
                nameOf(dialog).setText(folder.filePath(QStringLiteral("part")));
                save(dialog);
                whenOpen<QMessageBox>([replace](QMessageBox& question) {
                    question.button(replace ? QMessageBox::Yes : QMessageBox::No)->click();
                    if (!replace) // the dialog is open again
                        whenOpen<QFileDialog>([](QFileDialog& again) { again.reject(); });
                });
            });
            if (replace)
                QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, kPatience);
            QVERIFY(!station.session.work().current());
            QCOMPARE(*readFile(toPath(file)) == "mine", !replace);
        }
    }

    void aCancelKeepsTheFileOfBefore() {
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("part.obj"));
        QVERIFY(writeFile(toPath(file), "mine"));
        Workstation station(true);
        Session& session = station.session;
        Setup setup = session.job().setup();
        setup.automaticGrid = false;
        setup.spacing = 0.1;
        QVERIFY(session.job().setSetup(setup));
        QTRY_VERIFY_WITH_TIMEOUT(session.simulation().frame()->zmap.grid().nx > 1000, kPatience);
        for (const double from : {0.0, 0.7}) { // during decimation and during writing
            session.exports().exportMesh(file, {false});
            QTRY_VERIFY_WITH_TIMEOUT(!session.work().current() || session.work().current()->done > from,
                                     kPatience);
            QVERIFY2(session.work().current(), "done before it could be cancelled");
            session.work().cancel();
            QTRY_VERIFY_WITH_TIMEOUT(!session.work().current(), kPatience);
            QCOMPARE(session.problems().all().front().id, "cancelled");
            QCOMPARE(*readFile(toPath(file)), "mine");
            QCOMPARE(
                QDir(folder.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot).size(),
                1);
        }
    }

    void aFilterChosenBeforeANameIsTypedWritesNoName() {
        Workstation station(true);
        inDialog(station.window, "export-mesh", [](QFileDialog& dialog) {
            nameOf(dialog).clear();
            chooseFilter(dialog, 3);
            QCOMPARE(nameOf(dialog).text(), QString());
            dialog.reject();
        });
    }

    /// Where the step of float32 is 1/32 mm, an STL file cannot preserve the accuracy of the mesh.
    void roundingBeyondHalfOfTheAllowanceIsAProblemThatOffersDoubles() {
        QTemporaryDir folder;
        const QString program = folder.filePath(QStringLiteral("far.nc"));
        QVERIFY(writeFile(toPath(program), "T1 M6\nG0 X2000005 Y5 Z5\nG1 Z-2 F100\nX2000030\nG0 Z5\nM30\n"));
        Workstation station(false);
        station.open(program);
        Setup setup = station.session.job().setup();
        setup.stock = {{2000000.05, 0, 0}, 40, 30, 10};
        setup.automaticGrid = false;
        setup.spacing = 0.5;
        setup.tools.set(1, parseCutter("ball:d=4,l=20").value());
        QVERIFY(station.session.job().setSetup(setup));
        station.session.playback().seek(station.session.program().blockCount());
        QTRY_VERIFY_WITH_TIMEOUT(
            station.session.simulation().frame() && station.session.simulation().block() == 4, kPatience);
        QSignalSpy exported(&station.session.exports(), &ExportHub::exported);
        station.session.exports().exportMesh(folder.filePath(QStringLiteral("far.obj")), {});
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, kPatience);
        QVERIFY(station.session.problems().all().empty());
        QVERIFY(station.session.exports().last()->largestErrorMm <=
                station.session.job().parameters().allowance);
        const QString stl = folder.filePath(QStringLiteral("far.stl"));
        station.session.exports().exportMesh(stl, {});
        QTRY_VERIFY_WITH_TIMEOUT(!station.session.problems().all().empty(), kPatience);
        const Diagnostic problem = station.session.problems().all().front();
        QCOMPARE(problem.id, "export-rounding-too-large");
        QVERIFY2(hint(problem).contains(QLatin1String(".obj .ply .3mf")), qPrintable(hint(problem)));
        QCOMPARE(exported.count(), 1);
        QVERIFY(!QFile::exists(stl));
    }

private:
    std::unique_ptr<OwnSettings> m_settings;
};

} // namespace proveout

QTEST_MAIN(proveout::ExportTest)
#include "export_test.moc"
