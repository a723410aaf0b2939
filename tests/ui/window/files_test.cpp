// SPDX-License-Identifier: GPL-3.0-or-later
// Files in the window: unsaved changes are listed, and files that no longer exist are greyed out.
#include <algorithm>
#include <atomic>
#include <future>
#include <memory>

#include <QApplication>
#include <QFile>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "tests/ui/save_dialog_user.h"
#include "tests/ui/window/workstation.h"
#include "ui/document/recent_files.h"
#include "ui/editor/editor_panel.h"
#include "ui/editor/nc_editor.h"
#include "ui/window/start_page.h"

namespace proveout {
namespace {

/// The text of the question about unsaved changes, which is then cancelled. Empty if there is no question.
QString questionOf(MainWindow& window) {
    QString text;
    QTimer answer;
    QObject::connect(&answer, &QTimer::timeout, [&text] {
        if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
            text = box->text() + u'\n' + box->informativeText();
            box->reject();
        }
    });
    answer.start(20);
    return window.files().mayDiscard() ? QString() : text;
}

void write(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

QPushButton* buttonOf(const StartPage& page, const QString& file) {
    const QList<QPushButton*> buttons = page.findChildren<QPushButton*>();
    const auto found = std::ranges::find_if(
        buttons, [&](const QPushButton* button) { return button->toolTip().contains(file); });
    return found == buttons.end() ? nullptr : *found;
}

QAction* entryOf(const QMenu& menu, const QString& file) {
    const QList<QAction*> actions = menu.actions();
    const auto found =
        std::ranges::find_if(actions, [&](const QAction* action) { return action->text().contains(file); });
    return found == actions.end() ? nullptr : *found;
}

/// Answers message boxes with the button of this name while it exists.
class AnswerTo {
public:
    explicit AnswerTo(const QString& button) {
        QObject::connect(&m_look, &QTimer::timeout, [this, button] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (box == nullptr)
                return;
            ++m_asked;
            for (QAbstractButton* each : box->buttons())
                if (each->text().remove(u'&') == button)
                    each->click();
        });
        m_look.start(20);
    }
    [[nodiscard]] int asked() const { return m_asked; }

private:
    QTimer m_look;
    int m_asked = 0;
};

/// The full mesh of a fine grid takes seconds. There are no unsaved changes.
QString startLongExport(Workstation& station, const QTemporaryDir& folder) {
    station.open(sampleJobs().front().file);
    Setup setup = station.session.job().setup();
    setup.automaticGrid = false;
    setup.spacing = 0.1;
    const QString file = folder.filePath(QStringLiteral("part.stl"));
    if (!station.session.job().setSetup(setup) ||
        !station.session.document().saveJobAs(folder.filePath(QStringLiteral("fine.proveout"))))
        qFatal("the grid cannot be set");
    const auto fine = [&] {
        return station.session.simulation().frame() &&
               station.session.simulation().frame()->zmap.grid().hx < 0.11;
    };
    if (!QTest::qWaitFor(fine, kPatience))
        qFatal("no frame of the fine grid");
    ExportOptions full;
    full.decimated = false;
    station.session.exports().exportMesh(file, full);
    return file;
}

} // namespace

class FilesTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings = std::make_unique<OwnSettings>(); }

    void theQuestionNamesWhatIsUnsaved() {
        QTemporaryDir folder;
        const QString program = folder.filePath(QStringLiteral("bracket.nc"));
        write(program, "G21 G90\nT1 M6\nG0 X0 Y0 Z5\nG1 X5 F100\n");
        Workstation station(false);
        station.open(program);
        QVERIFY(questionOf(station.window).isEmpty());

        station.window.editor().editor().insertAt(QStringLiteral("(new)\n"), 0, 0);
        QVERIFY2(questionOf(station.window).contains(QLatin1String("bracket.nc")),
                 qPrintable(questionOf(station.window)));
        QVERIFY(!questionOf(station.window).contains(QLatin1String("job")));

        DecimationParameters parameters = station.session.job().parameters();
        parameters.allowance = 0.3;
        station.session.job().setParameters(parameters);
        Setup setup = station.session.job().setup();
        setup.automaticGrid = false;
        setup.spacing *= 2;
        QVERIFY(station.session.job().setSetup(setup));
        QString question = questionOf(station.window);
        QVERIFY2(question.contains(QLatin1String("bracket.nc")), qPrintable(question));
        QVERIFY2(question.contains(QLatin1String("not been saved as a job")), qPrintable(question));

        QVERIFY(station.session.document().saveJobAs(folder.filePath(QStringLiteral("fixture.proveout"))));
        QVERIFY(station.session.document().save());
        QVERIFY(questionOf(station.window).isEmpty());
        parameters.allowance = 0.2;
        station.session.job().setParameters(parameters);
        question = questionOf(station.window);
        QVERIFY2(question.contains(QLatin1String("fixture.proveout")), qPrintable(question));
        QVERIFY2(!question.contains(QLatin1String("bracket.nc")), qPrintable(question));
    }

    void aTextWithoutANameIsCalledNew() {
        Workstation station(false);
        station.session.document().newFile();
        station.window.editor().editor().insertAt(QStringLiteral("G0 X1\n"), 0, 0);
        QVERIFY2(questionOf(station.window).contains(QLatin1String("new program")),
                 qPrintable(questionOf(station.window)));
        station.session.document().setTextModified(false);
    }

    void aJobIsNotOverwrittenWithoutAQuestion() {
        QTemporaryDir folder;
        const QString program = folder.filePath(QStringLiteral("bracket.nc"));
        const QString job = folder.filePath(QStringLiteral("fixture.proveout"));
        write(program, "G21 G90\nT1 M6\nG0 X0 Y0 Z5\nG1 X5 F100\n");
        write(job, "mine");
        Workstation station(false);
        station.open(program);
        SaveDialogUser user(folder.filePath(QStringLiteral("fixture")));
        QVERIFY(!station.window.files().saveJobAs());
        QVERIFY2(user.question().contains(QLatin1String("fixture.proveout")), qPrintable(user.question()));
        QFile kept(job);
        QVERIFY(kept.open(QIODevice::ReadOnly));
        QCOMPARE(kept.readAll(), QByteArray("mine"));
    }

    void missingFilesAreGreyedWithTheReason() {
        QTemporaryDir folder;
        const QString gone = folder.filePath(QStringLiteral("gone.nc"));
        const QString there = folder.filePath(QStringLiteral("there.nc"));
        write(gone, "G0 X1\n");
        write(there, "G0 X1\n");
        Workstation station(false);
        station.window.files().recent().add(gone);
        station.window.files().recent().add(there);
        QVERIFY(QFile::remove(gone));
        auto* page = station.window.findChild<StartPage*>();
        station.window.hide();
        station.window.show(); // the page checks again whenever it is shown
        QTRY_VERIFY_WITH_TIMEOUT(buttonOf(*page, gone) != nullptr && !buttonOf(*page, gone)->isEnabled(),
                                 kPatience);
        QVERIFY2(buttonOf(*page, gone)->toolTip().contains(QLatin1String("not found")),
                 qPrintable(buttonOf(*page, gone)->toolTip()));
        QVERIFY(buttonOf(*page, there)->isEnabled());

        auto* menu = station.window.findChild<QMenu*>(QStringLiteral("recent-menu"));
        menu->popup(station.window.mapToGlobal(QPoint(50, 50)));
        QTRY_VERIFY_WITH_TIMEOUT(entryOf(*menu, gone) != nullptr && !entryOf(*menu, gone)->isEnabled(),
                                 kPatience);
        QVERIFY(menu->toolTipsVisible());
        QVERIFY(entryOf(*menu, gone)->toolTip().contains(QLatin1String("not found")));
        QVERIFY(entryOf(*menu, there)->isEnabled());
        menu->close();

        write(gone, "G0 X1\n");
        const auto cameBack = [&] {
            station.window.files().recent().look();
            return buttonOf(*page, gone)->isEnabled();
        };
        QTRY_VERIFY_WITH_TIMEOUT(cameBack(), kPatience);
    }

    void fault37ADriveThatDoesNotAnswerHoldsNothingUp() {
        std::promise<void> answer;
        std::shared_future<void> answered = answer.get_future().share();
        const auto asked = std::make_shared<std::atomic<int>>(0);
        {
            RecentFiles recent([answered, asked](const QString& file) {
                ++*asked;
                if (file.contains(QLatin1String("drive")))
                    answered.wait();
                return file.contains(QLatin1String("there"));
            });
            for (const char* file : {"/a/there.nc", "/a/gone.nc", "/drive/far.nc"})
                recent.add(QLatin1String(file));
            QSignalSpy changed(&recent, &RecentFiles::changed);
            recent.look();
            recent.look(); // pending checks are not started again
            QTRY_VERIFY_WITH_TIMEOUT(recent.isMissing(QStringLiteral("/a/gone.nc")), kPatience);
            QVERIFY(!recent.isMissing(QStringLiteral("/a/there.nc")));
            QVERIFY(!recent.isMissing(QStringLiteral("/drive/far.nc")));
            QVERIFY(!changed.isEmpty());
            QTRY_COMPARE_WITH_TIMEOUT(asked->load(), 3, kPatience);
        } // destroyed while the drive has not responded
        answer.set_value();
        QTest::qWait(50);
        QCOMPARE(asked->load(), 3);
    }

    void closingWaitsForAnExport() {
        QTemporaryDir folder;
        Workstation station(false);
        const QString file = startLongExport(station, folder);
        QSignalSpy exported(&station.session.exports(), &ExportHub::exported);
        {
            AnswerTo answer(QStringLiteral("Cancel"));
            QVERIFY(!station.window.close());
            QCOMPARE(answer.asked(), 1);
        }
        {
            AnswerTo answer(QStringLiteral("Wait for the File"));
            QVERIFY(!station.window.close());
            QCOMPARE(answer.asked(), 1);
        }
        QVERIFY(station.session.exports().isRunning());
        QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(station.window.isHidden(), kPatience);
        QVERIFY(QFile::exists(file));
    }

    void closingDropsAnExportWhenConfirmed() {
        QTemporaryDir folder;
        Workstation station(false);
        const QString file = startLongExport(station, folder);
        AnswerTo answer(QStringLiteral("Discard the File"));
        QVERIFY(station.window.close());
        QCOMPARE(answer.asked(), 1);
        QTRY_VERIFY_WITH_TIMEOUT(!station.session.exports().isRunning(), kPatience);
        QVERIFY(!QFile::exists(file));
    }

private:
    std::unique_ptr<OwnSettings> m_settings;
};

} // namespace proveout

int main(int argc, char** argv) {
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    proveout::FilesTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "files_test.moc"
