// SPDX-License-Identifier: GPL-3.0-or-later
// Saving next to other programs: their changes are never overwritten without a question.
#include <functional>
#include <memory>

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "tests/ui/window/workstation.h"
#include "ui/editor/editor_panel.h"
#include "ui/editor/nc_editor.h"
#include "ui/files/compare_dialog.h"
#include "ui/files/edited_elsewhere_bar.h"
#include "ui/files/file_changed_bar.h"
#include "ui/setup/setup_panel.h"

namespace proveout {
namespace {

const QByteArray kProgram = "G21 G90\nT1 M6\nG0 X0 Y0 Z5\nG1 X5 F100\n";
const QByteArray kTheirs = "G21 G90\nT1 M6\nG0 X0 Y0 Z5\nG1 X9 F100\n"; // of the same size

void write(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("%s cannot be written", qPrintable(path));
}

QByteArray read(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Presses the buttons of these names, one per question; keeps the texts of questions and comparisons.
class Answers {
public:
    explicit Answers(QStringList buttons) : m_buttons(std::move(buttons)) {
        QObject::connect(&m_look, &QTimer::timeout, [this] { act(QApplication::activeModalWidget()); });
        m_look.start(20);
    }
    [[nodiscard]] const QStringList& questions() const { return m_questions; }
    [[nodiscard]] const QString& compared() const { return m_compared; }

private:
    void act(QWidget* widget) {
        if (auto* dialog = qobject_cast<CompareDialog*>(widget)) {
            m_compared = dialog->findChild<QPlainTextEdit*>()->toPlainText();
            dialog->reject();
            return;
        }
        auto* box = qobject_cast<QMessageBox*>(widget);
        if (box == nullptr)
            return;
        m_questions << box->text() + u'\n' + box->informativeText();
        const QString wanted = m_buttons.isEmpty() ? QStringLiteral("Cancel") : m_buttons.takeFirst();
        for (QAbstractButton* each : box->buttons())
            if (each->text().remove(u'&') == wanted) {
                // Queued, because a timer does not fire while its slot waits for an answer.
                QMetaObject::invokeMethod(each, "click", Qt::QueuedConnection);
                return;
            }
        box->reject();
    }

    QStringList m_buttons;
    QStringList m_questions;
    QString m_compared;
    QTimer m_look;
};

void type(Workstation& station, const QString& text) {
    NcEditor& editor = station.window.editor().editor();
    editor.setFocus();
    editor.setCursorPosition(0, 0);
    QTest::keyClicks(&editor, text);
    if (!QTest::qWaitFor([&] { return station.session.document().text().modified; }, kPatience))
        qFatal("nothing was typed");
}

/// So long that it is written by another thread.
QByteArray longProgram() {
    return kProgram + QByteArray("X1 Y1 Z1\n").repeated(300'000) + "M30\n";
}

/// Calls it while the `nth` comparison or save of a long text is in progress.
void during(Workstation& station, int nth, const std::function<void()>& act) {
    DocumentWriter& writer = station.session.document().writer();
    auto left = std::make_shared<int>(nth);
    QObject::connect(&writer, &DocumentWriter::started, &station.window, [=, &station] {
        if (--*left == 0)
            QTimer::singleShot(0, &station.window, act);
    });
}

void pressSave(Workstation& station) {
    station.press(Qt::Key_S, Qt::ControlModifier);
}

FileChangedBar* bar(Workstation& station, FilePart part) {
    for (FileChangedBar* each : station.window.findChildren<FileChangedBar*>())
        if (station.window.editor().isAncestorOf(each) == (part == FilePart::text))
            return each;
    return nullptr;
}

void press(FileChangedBar& bar, const QString& name) {
    for (QPushButton* each : bar.findChildren<QPushButton*>())
        if (each->text().remove(u'&') == name)
            return each->click();
    qFatal("no button %s", qPrintable(name));
}

} // namespace

class SavingTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_settings = std::make_unique<OwnSettings>();
        m_folder = std::make_unique<QTemporaryDir>();
        m_program = m_folder->filePath(QStringLiteral("bracket.nc"));
        write(m_program, kProgram);
    }

    void aNewerFileIsNotOverwrittenWithoutAQuestion() {
        Workstation station(false);
        station.open(m_program);
        type(station, QStringLiteral("(mine)"));
        write(m_program, kTheirs); // the window has not been notified yet
        Answers answers({QStringLiteral("Cancel")});
        pressSave(station);
        QCOMPARE(answers.questions().size(), 1);
        QVERIFY2(answers.questions().front().contains(QLatin1String("bracket.nc has changed on disk")),
                 qPrintable(answers.questions().front()));
        QCOMPARE(read(m_program), kTheirs);
        QVERIFY(station.session.document().text().modified);
        QVERIFY(!station.session.document().save()); // the session itself refuses too
        QCOMPARE(read(m_program), kTheirs);
        station.session.document().setTextModified(false);
    }

    void aChangeOfTheSameSizeAndTimeIsSeen() {
        Workstation station(false);
        const auto time = std::filesystem::last_write_time(m_program.toStdString());
        station.open(m_program);
        type(station, QStringLiteral("(mine)"));
        write(m_program, kTheirs);
        std::filesystem::last_write_time(m_program.toStdString(), time);
        Answers answers({});
        pressSave(station);
        QCOMPARE(answers.questions().size(), 1);
        QCOMPARE(read(m_program), kTheirs);
    }

    void overwritesWhenConfirmed() {
        Workstation station(false);
        station.open(m_program);
        type(station, QStringLiteral("(mine)"));
        write(m_program, kTheirs);
        Answers answers({QStringLiteral("Overwrite")});
        pressSave(station);
        QCOMPARE(answers.questions().size(), 1);
        QCOMPARE(read(m_program), "(mine)" + kProgram);
        QVERIFY(!station.session.document().modified());
        QTest::qWait(400); // the watcher has reported it by now
        QVERIFY(!bar(station, FilePart::text)->isVisible());
        type(station, QStringLiteral("(more)"));
        pressSave(station); // the window's own save is not a change by another program
        QCOMPARE(answers.questions().size(), 1);
        QCOMPARE(read(m_program), "(more)(mine)" + kProgram);
    }

    void keepsBothUnderANewName() {
        write(m_folder->filePath(QStringLiteral("bracket-2.nc")), "taken");
        Workstation station(false);
        station.open(m_program);
        type(station, QStringLiteral("(mine)"));
        write(m_program, kTheirs);
        Answers answers({QStringLiteral("Keep Both")});
        pressSave(station);
        const QString beside = m_folder->filePath(QStringLiteral("bracket-3.nc"));
        QCOMPARE(read(m_program), kTheirs);
        QCOMPARE(read(m_folder->filePath(QStringLiteral("bracket-2.nc"))), QByteArray("taken"));
        QCOMPARE(read(beside), "(mine)" + kProgram);
        QVERIFY(!station.session.document().modified());
        QVERIFY(station.window.windowTitle().startsWith(QLatin1String("bracket-3.nc")));
        const QString message = station.window.statusBar()->currentMessage();
        QVERIFY2(message.contains(QLatin1String("bracket-3.nc")), qPrintable(message));
    }

    void comparesBeforeTheAnswer() {
        Workstation station(false);
        station.open(m_program);
        type(station, QStringLiteral("(mine)"));
        write(m_program, kTheirs);
        Answers answers({QStringLiteral("Compare…"), QStringLiteral("Cancel")});
        pressSave(station);
        QVERIFY2(answers.compared().contains(QLatin1String("+ (mine)G21 G90")),
                 qPrintable(answers.compared()));
        QVERIFY(answers.compared().contains(QStringLiteral("\u2212 G1 X9 F100")));
        QVERIFY(answers.compared().contains(QLatin1String("+ G1 X5 F100")));
        QCOMPARE(read(m_program), kTheirs);
    }

    void theJobFileIsAskedAboutToo() {
        Workstation station(false);
        station.open(m_program);
        const QString job = m_folder->filePath(QStringLiteral("bracket.proveout"));
        QVERIFY(station.session.document().saveJobAs(job));
        const QByteArray before = read(job);
        DecimationParameters parameters = station.session.job().parameters();
        parameters.allowance = 0.25;
        station.session.job().setParameters(parameters);
        const QByteArray theirs =
            QByteArray(before).replace("\"blockDelete\": false", "\"blockDelete\": true");
        QVERIFY(theirs != before);
        write(job, theirs);
        {
            Answers answers({QStringLiteral("Compare…"), QStringLiteral("Cancel")});
            pressSave(station);
            QVERIFY(answers.questions().value(0).contains(QLatin1String("bracket.proveout")));
            QVERIFY2(answers.compared().contains(QLatin1String("blockDelete")),
                     qPrintable(answers.compared()));
        }
        QCOMPARE(read(job), theirs);
        Answers answers({QStringLiteral("Keep Both")});
        pressSave(station);
        QCOMPARE(read(job), theirs);
        QCOMPARE(QFileInfo(station.session.document().jobFile()).fileName(),
                 QStringLiteral("bracket-2.proveout"));
        QVERIFY(read(station.session.document().jobFile()).contains("0.25"));
        QVERIFY(!station.session.document().modified());
    }

    void aChangedJobIsShownInTheSetupAndReadAgain() {
        Workstation station(false);
        station.open(m_program);
        const QString job = m_folder->filePath(QStringLiteral("bracket.proveout"));
        QVERIFY(station.session.document().saveJobAs(job));
        FileChangedBar* reported = bar(station, FilePart::job);
        QVERIFY(reported->isHidden());
        write(job, read(job).replace("\"blockDelete\": false", "\"blockDelete\": true"));
        QTRY_VERIFY_WITH_TIMEOUT(!reported->isHidden(), kPatience);
        press(*reported, QStringLiteral("Reload"));
        QTRY_VERIFY_WITH_TIMEOUT(station.session.job().setup().blockDelete, kPatience);
        QVERIFY(reported->isHidden());
        QVERIFY(!station.session.document().modified());
    }

    void twoWindowsOnOneFileDoNotOverwriteEachOther() {
        Workstation first(false);
        Workstation second(false);
        first.open(m_program);
        second.open(m_program);
        second.window.activateWindow();
        type(second, QStringLiteral("(second)"));
        QVERIFY(second.window.files().save());
        first.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&first.window));
        type(first, QStringLiteral("(first)"));
        Answers answers({QStringLiteral("Cancel")});
        QVERIFY(!first.window.files().save());
        QCOMPARE(answers.questions().size(), 1);
        QCOMPARE(read(m_program), "(second)" + kProgram);
        QTRY_VERIFY_WITH_TIMEOUT(bar(first, FilePart::text)->isVisible(), kPatience);
        first.session.document().setTextModified(false);
    }

    void afterKeepMyVersionTheSaveDoesNotAskAgain() {
        Workstation station(false);
        station.open(m_program);
        write(m_program, kTheirs);
        QTRY_VERIFY_WITH_TIMEOUT(bar(station, FilePart::text)->isVisible(), kPatience);
        press(*bar(station, FilePart::text), QStringLiteral("Keep My Version"));
        QVERIFY(station.session.document().text().modified);
        Answers answers({});
        pressSave(station);
        QCOMPARE(answers.questions().size(), 0);
        QCOMPARE(read(m_program), kProgram);
        write(m_program, kTheirs);
        type(station, QStringLiteral("(mine)"));
        pressSave(station); // this is another change
        QCOMPARE(answers.questions().size(), 1);
        station.session.document().setTextModified(false);
    }

    void theSameContentWrittenAgainIsNoNews() {
        Workstation station(false);
        station.open(m_program);
        QSignalSpy changed(&station.session.document(), &DocumentHub::fileChangedOnDisk);
        write(m_program, kProgram);
        QTest::qWait(600);
        QCOMPARE(changed.count(), 0);
        type(station, QStringLiteral("(mine)"));
        Answers answers({});
        pressSave(station);
        QCOMPARE(answers.questions().size(), 0);
        QCOMPARE(read(m_program), "(mine)" + kProgram);
    }

    void aFileThatHoldsWhatWouldBeWrittenIsNotAskedAbout() {
        Workstation station(false);
        station.open(m_program);
        const QString job = m_folder->filePath(QStringLiteral("bracket.proveout"));
        QVERIFY(station.session.document().saveJobAs(job));
        type(station, QStringLiteral("(mine)"));
        write(m_program, "(mine)" + kProgram);
        const QByteArray before = read(job);
        Setup setup = station.session.job().setup();
        setup.blockDelete = true;
        QVERIFY(station.session.job().setSetup(setup).has_value());
        write(job, QByteArray(before).replace("\"blockDelete\": false", "\"blockDelete\": true"));
        QVERIFY(read(job) != before);
        Answers answers({});
        pressSave(station);
        QCOMPARE(answers.questions(), QStringList());
        QVERIFY(!station.session.document().modified());
        QCOMPARE(read(m_program), "(mine)" + kProgram);
    }

    void aDeletedFileIsWrittenAgain() {
        Workstation station(false);
        station.open(m_program);
        QVERIFY(QFile::remove(m_program));
        QTRY_VERIFY_WITH_TIMEOUT(station.session.document().modified(), kPatience);
        QVERIFY(bar(station, FilePart::text)->isVisible());
        Answers answers({});
        pressSave(station);
        QCOMPARE(answers.questions().size(), 0);
        QCOMPARE(read(m_program), kProgram);
        QVERIFY(!bar(station, FilePart::text)->isVisible());
    }

    void whatCannotBeOverwrittenIsSaidClearly() {
        Workstation station(false);
        station.open(m_program);
        type(station, QStringLiteral("(mine)"));
        QVERIFY(QFile::setPermissions(m_program, QFile::ReadOwner));
        Answers answers({});
        pressSave(station);
        QCOMPARE(read(m_program), kProgram);
        QVERIFY(!station.session.problems().all().empty());
        QCOMPARE(station.session.problems().all().front().id, "file-unwritable");
        QVERIFY(*station.session.problems().all().front().hint != '\0');

        QVERIFY(QFile::remove(m_program));
        QVERIFY(QDir().mkpath(m_program));
        pressSave(station);
        QCOMPARE(station.session.problems().all().front().id, "file-not-regular");
        QVERIFY(station.session.document().text().modified);
        QVERIFY(QDir(m_program).exists());
        QCOMPARE(answers.questions().size(), 0);
        station.session.document().setTextModified(false);
    }

    void theStarIsOnWhatIsUnsaved() {
        Workstation station(false);
        station.open(m_program);
        const QString job = m_folder->filePath(QStringLiteral("bracket.proveout"));
        QVERIFY(station.session.document().saveJobAs(job));
        const auto dock = [&](const char* id) {
            return station.window.findChild<QWidget*>(QLatin1String(id))->windowTitle();
        };
        QVERIFY(!station.window.isWindowModified());
        QCOMPARE(dock("dock-program"), QStringLiteral("NC Program"));
        type(station, QStringLiteral("(mine)"));
        QCOMPARE(station.window.windowTitle(),
                 QStringLiteral("bracket.nc[*] (bracket.proveout) \u2013 Proveout"));
        QVERIFY(station.window.isWindowModified());
        QCOMPARE(dock("dock-program"), QStringLiteral("NC Program*"));
        QCOMPARE(dock("dock-setup"), QStringLiteral("Setup"));
        pressSave(station);
        QVERIFY(!station.window.isWindowModified());

        Setup setup = station.session.job().setup();
        setup.tools.set(7, parseCutter("flat:d=6,l=20").value());
        QVERIFY(station.session.job().setSetup(setup));
        QCOMPARE(station.window.windowTitle(),
                 QStringLiteral("bracket.nc (bracket.proveout[*]) \u2013 Proveout"));
        QCOMPARE(dock("dock-program"), QStringLiteral("NC Program"));
        QCOMPARE(dock("dock-setup"), QStringLiteral("Setup*"));
        QVERIFY(station.session.document().job().toolsModified());
        pressSave(station); // the text has been saved already
        QVERIFY(read(job).contains("\"7\""));
        QVERIFY(!station.window.isWindowModified());
        QVERIFY2(station.window.statusBar()->currentMessage().contains(QLatin1String("bracket.proveout")),
                 qPrintable(station.window.statusBar()->currentMessage()));

        const Setup saved = station.session.job().setup();
        setup.automaticGrid = false;
        setup.spacing *= 2;
        QVERIFY(station.session.job().setSetup(setup));
        QVERIFY(station.session.document().jobModified());
        QVERIFY(station.session.job().setSetup(saved)); // as undo does
        QVERIFY(!station.session.document().jobModified());
    }

    void aSecondWindowSaysThatTheFileIsEditedInTheFirst() {
        const QString job = m_folder->filePath(QStringLiteral("bracket.proveout"));
        Workstation first(false);
        first.open(m_program);
        QVERIFY(first.session.document().saveJobAs(job));
        type(first, QStringLiteral("(mine)"));
        Setup setup = first.session.job().setup();
        setup.blockDelete = !setup.blockDelete;
        QVERIFY(first.session.job().setSetup(setup));
        Workstation second(false);
        second.open(job);
        const auto shown = [&](const QWidget& panel) {
            const auto* bar = panel.findChild<EditedElsewhereBar*>();
            return bar != nullptr && bar->isVisibleTo(&panel) ? bar->findChild<QLabel*>()->text() : QString();
        };
        const QWidget& editor = second.window.editor();
        const QWidget& panel = *second.window.findChild<SetupPanel*>();
        QVERIFY2(shown(editor).startsWith(QLatin1String("bracket.nc has unsaved changes")),
                 qPrintable(shown(editor)));
        QVERIFY(shown(editor).contains(QString::number(QCoreApplication::applicationPid())));
        QVERIFY2(shown(panel).startsWith(QLatin1String("bracket.proveout has unsaved changes")),
                 qPrintable(shown(panel)));
        QVERIFY(shown(first.window.editor()).isEmpty());
        QVERIFY(first.session.document().save());
        QTRY_VERIFY_WITH_TIMEOUT(shown(editor).isEmpty() && shown(panel).isEmpty(), kPatience);
    }

    // A long text is written by another thread.

    void anEditDuringASaveIsKeptAsUnsaved() {
        write(m_program, longProgram());
        Workstation station(false);
        station.open(m_program);
        NcEditor& editor = station.window.editor().editor();
        type(station, QStringLiteral("(a)"));
        bool isWriting = false;
        during(station, 2, [&] {
            isWriting = station.session.document().writer().isRunning();
            QTest::keyClicks(&editor, QStringLiteral("(b)"));
        });
        QVERIFY(station.window.files().save());
        QVERIFY(isWriting);
        QCOMPARE(read(m_program), "(a)" + longProgram());
        QVERIFY(station.session.document().text().modified);
        // Without the edit, the text is that of the file; it still counts as unsaved.
        for (int k = 0; k < 3; ++k)
            QTest::keyClick(&editor, Qt::Key_Backspace);
        QVERIFY(station.session.document().text().modified);
        QTest::keyClicks(&editor, QStringLiteral("(c)"));
        QVERIFY(station.window.files().save());
        QCOMPARE(read(m_program), "(a)(c)" + longProgram());
        QVERIFY(!station.session.document().text().modified);
        QTest::qWait(500); // the watch of the file settles
        QVERIFY(!bar(station, FilePart::text)->isVisible());
    }

    void aSecondSaveDuringASaveWritesTheNewestText() {
        write(m_program, longProgram());
        Workstation station(false);
        station.open(m_program);
        NcEditor& editor = station.window.editor().editor();
        type(station, QStringLiteral("(a)"));
        during(station, 2, [&] {
            QTest::keyClicks(&editor, QStringLiteral("(b)"));
            QVERIFY(!station.window.files().save());
            QVERIFY(!station.session.document().save());
        });
        QVERIFY(station.window.files().save());
        QCOMPARE(read(m_program), "(a)(b)" + longProgram());
        QVERIFY(!station.session.document().text().modified);
    }

    void aWindowClosesAfterTheSave() {
        write(m_program, longProgram());
        Workstation station(false);
        station.open(m_program);
        type(station, QStringLiteral("(a)"));
        bool closed = true;
        during(station, 2, [&] { closed = station.window.close(); });
        QVERIFY(station.window.files().save());
        QVERIFY(!closed);
        QTRY_VERIFY_WITH_TIMEOUT(!station.window.isVisible(), kPatience);
        QCOMPARE(read(m_program), "(a)" + longProgram());
    }

    void aSaveThatFailsKeepsTheWindowOpen() {
        write(m_program, longProgram());
        Workstation station(false);
        station.open(m_program);
        type(station, QStringLiteral("(a)"));
        write(m_program, "(theirs)" + longProgram());
        bool closed = true;
        during(station, 1, [&] { closed = station.window.close(); });
        QVERIFY(!station.session.document().save());
        QVERIFY(!closed);
        QVERIFY(station.session.document().text().modified);
        QVERIFY(!station.session.problems().all().empty());
        QTest::qWait(100);
        QVERIFY(station.window.isVisible());
        QCOMPARE(read(m_program), "(theirs)" + longProgram());
        QTRY_VERIFY_WITH_TIMEOUT(bar(station, FilePart::text)->isVisible(), kPatience);
        station.session.document().setTextModified(false);
    }

    void anotherFileIsOpenedAfterTheSave() {
        const QString other = m_folder->filePath(QStringLiteral("other.nc"));
        write(other, kTheirs);
        write(m_program, longProgram());
        Workstation station(false);
        station.open(m_program);
        type(station, QStringLiteral("(a)"));
        bool opening = false;
        during(station, 2, [&] { opening = station.window.files().open(other); });
        QVERIFY(station.window.files().save());
        QVERIFY(opening);
        QCOMPARE(read(m_program), "(a)" + longProgram());
        QTRY_COMPARE_WITH_TIMEOUT(QString::fromStdString(station.session.document().text().path.string()),
                                  other, kPatience);
        QVERIFY(!station.session.document().text().modified);
    }

    void aNewProgramCanBeTypedAtOnce() {
        Workstation station(false);
        QTest::keyClick(&station.window, Qt::Key_N, Qt::ControlModifier);
        QVERIFY(station.session.document().isOpen());
        QTRY_VERIFY_WITH_TIMEOUT(station.window.editor().editor().hasFocus(), kPatience);
        QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("G0 X1"));
        QCOMPARE(station.session.document().text().text.toString(), std::string("G0 X1"));
        station.session.document().setTextModified(false);
    }

private:
    std::unique_ptr<OwnSettings> m_settings;
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_program;
};

} // namespace proveout

int main(int argc, char** argv) {
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    proveout::SavingTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "saving_test.moc"
