// SPDX-License-Identifier: GPL-3.0-or-later
// Unsaved work survives a session that is killed. The session under test is a separate process: this program
// started again, with a first argument that makes it type and wait to be killed.
#include <memory>

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QProcess>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "tests/ui/window/workstation.h"
#include "ui/document/file_paths.h"
#include "ui/editor/editor_panel.h"
#include "ui/editor/nc_editor.h"
#include "ui/files/compare_dialog.h"
#include "ui/window/recovery.h"
#include "ui/window/recovery_bar.h"

namespace proveout {
namespace {

const QByteArray kProgram = "G21 G90\nT1 M6\nG0 X0 Y0 Z5\nG1 X5 F100\n";
const QByteArray kTyped = "(typed)";
const QString kVictim = QStringLiteral("--victim");

void write(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("%s cannot be written", qPrintable(path));
}

QByteArray read(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QStringList foldersIn(const QString& root) {
    return QDir(root).entryList(QDir::Dirs | QDir::NoDotAndDotDot);
}

/// The process to be killed: types into `program` (empty: a new one), changes the setup, sets a breakpoint,
/// and keeps running. Its unsaved work is backed up after some seconds.
int victim(const QString& root, const QString& program) {
    const OwnSettings settings;
    Workstation station(false);
    Recovery recovery(station.window, root);
    if (program.isEmpty())
        station.window.files().newFile();
    else
        station.open(program);
    NcEditor& editor = station.window.editor().editor();
    editor.setFocus();
    editor.setCursorPosition(0, 0);
    QTest::keyClicks(&editor, QString::fromLatin1(kTyped));
    Setup setup = station.session.job().setup();
    setup.tools.set(7, parseCutter("flat:d=6,l=20").value());
    if (!station.session.job().setSetup(setup))
        return 1;
    station.session.breakpoints().toggle(3);
    return QApplication::exec();
}

/// Kills such a process as soon as its work is backed up; returns the seconds until then.
double killOne(const QString& root, const QString& program) {
    QProcess process;
    process.setProcessChannelMode(QProcess::ForwardedChannels);
    const QStringList before = foldersIn(root);
    process.start(QApplication::applicationFilePath(), {kVictim, root, program});
    QElapsedTimer timer;
    timer.start();
    const auto kept = [&] {
        for (const QString& folder : foldersIn(root))
            if (!before.contains(folder) &&
                read(root + u'/' + folder + QStringLiteral("/session.json")).contains("breakpoints") &&
                read(root + u'/' + folder + QStringLiteral("/program.nc")).contains(kTyped) &&
                read(root + u'/' + folder + QStringLiteral("/job.proveout")).contains("\"7\""))
                return true;
        return false;
    };
    if (!QTest::qWaitFor(kept, 2 * kPatience))
        qFatal("nothing was kept");
    const double seconds = static_cast<double>(timer.elapsed()) / 1000;
    process.kill(); // SIGKILL
    process.waitForFinished();
    if (process.exitStatus() != QProcess::CrashExit)
        qFatal("it ended by itself");
    return seconds;
}

RecoveryBar& barOf(Workstation& station) {
    return *station.window.findChild<RecoveryBar*>();
}

QList<QPushButton*> buttons(Workstation& station, const QString& name) {
    QList<QPushButton*> found;
    for (QPushButton* each : barOf(station).findChildren<QPushButton*>())
        if (each->text() == name && each->isVisible())
            found << each;
    return found;
}

} // namespace

class RecoveryTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_settings = std::make_unique<OwnSettings>();
        m_folder = std::make_unique<QTemporaryDir>();
        m_root = m_folder->filePath(QStringLiteral("recovery"));
        m_program = m_folder->filePath(QStringLiteral("bracket.nc"));
        write(m_program, kProgram);
    }

    void whatWasTypedComesBackAfterAKill() {
        killOne(m_root, m_program);
        QCOMPARE(read(m_program), kProgram); // unchanged
        Workstation station(false);
        Recovery recovery(station.window, m_root);
        QVERIFY(barOf(station).isVisible());
        QCOMPARE(buttons(station, QStringLiteral("Restore")).size(), 1);
        QTest::mouseClick(buttons(station, QStringLiteral("Restore")).front(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(station.session.document().isOpen(), kPatience);
        QCOMPARE(QByteArray::fromStdString(station.session.document().text().text.toString()),
                 kTyped + kProgram);
        QVERIFY(station.session.document().text().modified);
        QCOMPARE(toQString(station.session.document().text().path), m_program);
        QVERIFY(station.session.job().setup().tools.find(7) != nullptr);
        QVERIFY(station.session.document().jobModified());
        QCOMPARE(station.session.breakpoints().all().size(), std::size_t{1});
        QCOMPARE(station.session.breakpoints().all().front().line, 3U);
        QCOMPARE(read(m_program), kProgram);
        // The work is now in the folder of this session, and in no other.
        QTRY_VERIFY_WITH_TIMEOUT(!barOf(station).isVisible(), kPatience);
        QCOMPARE(foldersIn(m_root).size(), 1);
        QVERIFY(station.window.files().save()); // the file has not changed meanwhile, so there is no question
        QCOMPARE(read(m_program), kTyped + kProgram);
        recovery.end();
        QTRY_VERIFY_WITH_TIMEOUT(foldersIn(m_root).isEmpty(), kPatience);
    }

    void severalSessionsAreListedAndNewProgramsToo() {
        killOne(m_root, m_program);
        killOne(m_root, {});
        Workstation station(false);
        Recovery recovery(station.window, m_root);
        QCOMPARE(buttons(station, QStringLiteral("Restore")).size(), 2);
        QTest::mouseClick(buttons(station, QStringLiteral("Restore")).front(),
                          Qt::LeftButton); // the newer session
        QTRY_VERIFY_WITH_TIMEOUT(station.session.document().isOpen(), kPatience);
        QVERIFY(station.session.document().text().path.empty());
        QCOMPARE(QByteArray::fromStdString(station.session.document().text().text.toString()), kTyped);
        QTRY_COMPARE_WITH_TIMEOUT(buttons(station, QStringLiteral("Restore")).size(), 1, kPatience);
        recovery.end();
    }

    void comparesAndDiscards() {
        killOne(m_root, m_program);
        Workstation station(false);
        Recovery recovery(station.window, m_root);
        QString compared;
        QTimer answer;
        connect(&answer, &QTimer::timeout, this, [&] {
            if (auto* dialog = qobject_cast<CompareDialog*>(QApplication::activeModalWidget())) {
                for (QPlainTextEdit* page : dialog->findChildren<QPlainTextEdit*>())
                    compared += page->toPlainText();
                dialog->reject();
            } else if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                box->button(QMessageBox::Discard)->click();
            }
        });
        answer.start(20);
        QTest::mouseClick(buttons(station, QStringLiteral("Compare…")).front(), Qt::LeftButton);
        QVERIFY2(compared.contains(QString::fromLatin1("+ " + kTyped + "G21 G90")), qPrintable(compared));
        QTest::mouseClick(buttons(station, QStringLiteral("Discard")).front(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!barOf(station).isVisible(), kPatience);
        QCOMPARE(read(m_program), kProgram);
        QVERIFY(foldersIn(m_root).size() <= 1);
        QVERIFY(!station.session.document().isOpen());
        recovery.end();
    }

    void aFileThatHasChangedSinceIsAskedAbout() {
        killOne(m_root, m_program);
        write(m_program, "G21\n"); // by another program, before the restart
        Workstation station(false);
        Recovery recovery(station.window, m_root);
        QTest::mouseClick(buttons(station, QStringLiteral("Restore")).front(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(station.session.document().isOpen(), kPatience);
        QVERIFY(station.session.document().conflict());
        QVERIFY(!station.session.document().save());
        QCOMPARE(read(m_program), QByteArray("G21\n"));
        recovery.end();
    }

    void aRunningSessionIsNotOffered() {
        Workstation first(false);
        Recovery running(first.window, m_root);
        first.open(m_program);
        first.session.document().applyEdit(0, 0, "(first)");
        first.session.document().setTextModified(true);
        bool kept = false;
        running.autosave().keepNow([&] { kept = true; });
        QTRY_VERIFY_WITH_TIMEOUT(kept, kPatience);
        {
            Workstation second(false);
            Recovery recovery(second.window, m_root);
            QVERIFY(!barOf(second).isVisible());
            QCOMPARE(foldersIn(m_root).size(), 2);
            recovery.end();
        }
        QCOMPARE(foldersIn(m_root).size(), 1); // the first session's folder is unchanged
        running.end();
        QTRY_VERIFY_WITH_TIMEOUT(foldersIn(m_root).isEmpty(), kPatience);
    }

    void whatIsSavedIsKeptNoLonger() {
        Workstation station(false);
        Recovery recovery(station.window, m_root);
        station.open(m_program);
        station.session.document().applyEdit(0, 0, "(mine)");
        station.session.document().setTextModified(true);
        const QString folder = m_root + u'/' + foldersIn(m_root).front();
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(folder + QStringLiteral("/program.nc")),
                                 2 * Autosave::kIntervalMs + kPatience);
        QVERIFY(station.session.document().save());
        QTRY_VERIFY_WITH_TIMEOUT(!QFile::exists(folder + QStringLiteral("/program.nc")),
                                 2 * Autosave::kIntervalMs + kPatience);
        recovery.end();
    }

    void aDamagedRecordDoesNotTakeTheTextAlong() {
        const QString folder = m_root + QStringLiteral("/some");
        QVERIFY(QDir().mkpath(folder));
        write(folder + QStringLiteral("/session.json"), "{\"program\": ");
        write(folder + QStringLiteral("/program.nc"), kProgram);
        QVERIFY(QDir().mkpath(m_root + QStringLiteral("/empty")));
        Workstation station(false);
        Recovery recovery(station.window, m_root);
        QCOMPARE(buttons(station, QStringLiteral("Restore")).size(), 1);
        QTest::mouseClick(buttons(station, QStringLiteral("Restore")).front(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(station.session.document().isOpen(), kPatience);
        QCOMPARE(QByteArray::fromStdString(station.session.document().text().text.toString()), kProgram);
        QVERIFY(station.session.document().text().path.empty());
        recovery.end();
    }

    void theBytesOfTheTextSurvive() {
        const QByteArray bytes = "\xEF\xBB\xBF(Fr\xC3\xA4ser)\r\nG0 X1\r\n\r\nG1 X2 F100";
        write(m_program, bytes);
        Workstation station(false);
        station.open(m_program);
        station.session.document().applyEdit(0, 0, "%");
        station.session.document().setTextModified(true);
        const QString folder = m_folder->filePath(QStringLiteral("kept"));
        QVERIFY(QDir().mkpath(folder));
        QVERIFY(keepSession(folder, station.session.document().job(), {{}, "layout"}));
        const auto kept = readKeptSession(folder);
        QVERIFY(kept);
        QCOMPARE(kept->state.layout, QByteArray("layout"));
        const auto restored = JobDocument::restore(kept->work);
        QVERIFY(restored);
        QVERIFY(restored->text().modified);
        QVERIFY(restored->text().byteOrderMark);
        QCOMPARE(restored->text().lineEnd, LineEnd::crLf);
        QCOMPARE(restored->text().text.toString(), station.session.document().text().text.toString());
        QVERIFY(!restored->conflict(FilePart::text));
        station.session.document().setTextModified(false);
    }

    void theLayoutComesBack() {
        {
            Workstation station(false);
            station.window.resize(1000, 700);
            station.window.findChild<QWidget*>(QStringLiteral("dock-tuning"))->hide();
            const QString folder = m_root + QStringLiteral("/killed");
            QVERIFY(QDir().mkpath(folder));
            QVERIFY(keepSession(folder, station.session.document().job(), {{}, station.window.layout()}));
        }
        Workstation station(false);
        QVERIFY(station.window.findChild<QWidget*>(QStringLiteral("dock-tuning"))->isVisible());
        Recovery recovery(station.window, m_root);
        QVERIFY(!station.window.findChild<QWidget*>(QStringLiteral("dock-tuning"))->isVisible());
        QVERIFY(!barOf(station).isVisible()); // nothing is unsaved, so there is no question
        QTRY_COMPARE_WITH_TIMEOUT(station.window.size(), QSize(1000, 700), kPatience);
        recovery.end();
    }

private:
    std::unique_ptr<OwnSettings> m_settings;
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_root;
    QString m_program;
};

} // namespace proveout

int main(int argc, char** argv) {
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    const QStringList arguments = QApplication::arguments();
    if (arguments.value(1) == proveout::kVictim)
        return proveout::victim(arguments.value(2), arguments.value(3));
    proveout::RecoveryTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "recovery_test.moc"
