// SPDX-License-Identifier: GPL-3.0-or-later
// Jobs that name files outside their folder: the user is asked once.
#include <memory>

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "tests/ui/window/workstation.h"

namespace proveout {
namespace {

void write(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("%s cannot be written", qPrintable(path));
}

/// Answers every question with the button of this name, and keeps the texts.
class Answer {
public:
    explicit Answer(const QString& button) {
        QObject::connect(&m_look, &QTimer::timeout, [this, button] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (box == nullptr || !m_last.isNull())
                return;
            m_last = box;
            m_questions << box->text();
            for (QAbstractButton* each : box->buttons())
                if (each->text().remove(u'&') == button)
                    QMetaObject::invokeMethod(each, "click", Qt::QueuedConnection);
        });
        m_look.start(20);
    }
    [[nodiscard]] const QStringList& questions() const { return m_questions; }

private:
    QTimer m_look;
    QPointer<QMessageBox> m_last;
    QStringList m_questions;
};

} // namespace

class OutsideTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_settings = std::make_unique<OwnSettings>();
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("jobs")));
        m_program = m_folder->filePath(QStringLiteral("bracket.nc"));
        m_job = m_folder->filePath(QStringLiteral("jobs/bracket.proveout"));
        write(m_program, "G21 G90\nT1 M6\nG0 X0 Y0 Z5\nG1 Z-1 F100\n");
        write(
            m_job,
            R"({"proveout": 2, "note": "not a field", "program": "../bracket.nc", "tools": {"1": "ball:d=4,l=20"}, "grid": 1,
                         "stock": {"width": 40, "depth": 30, "height": 10}})");
    }

    void aJobFromElsewhereIsNotOpenedUnlessAllowed() {
        Workstation station(false);
        Answer answer(QStringLiteral("Cancel"));
        station.window.files().open(m_job);
        QTRY_COMPARE_WITH_TIMEOUT(answer.questions().size(), 1, kPatience);
        QVERIFY2(answer.questions().front().contains(QFileInfo(m_program).canonicalFilePath()),
                 qPrintable(answer.questions().front()));
        QVERIFY(openingIsOver(station.session));
        QVERIFY(!station.session.document().isOpen());
        QCOMPARE(station.session.problems().all().front().id, "job-outside");
    }

    void whatIsAllowedIsRemembered() {
        {
            Workstation station(false);
            Answer answer(QStringLiteral("Allow and Open"));
            station.window.files().open(m_job);
            QTRY_VERIFY_WITH_TIMEOUT(station.session.simulation().frame() != nullptr, kPatience);
            QCOMPARE(answer.questions().size(), 1);
            QCOMPARE(QFileInfo(station.session.document().jobFile()).fileName(),
                     QStringLiteral("bracket.proveout"));
        }
        Workstation station(false);
        Answer answer(QStringLiteral("Cancel"));
        station.open(m_job);
        QCOMPARE(answer.questions().size(), 0);
        // The permission applies only to these files.
        write(m_folder->filePath(QStringLiteral("other.nc")), "G0 X1\n");
        write(m_job, R"({"proveout": 2, "program": "../other.nc",
                         "stock": {"width": 40, "depth": 30, "height": 10}})");
        Workstation other(false);
        other.window.files().open(m_job);
        QTRY_COMPARE_WITH_TIMEOUT(answer.questions().size(), 1, kPatience);
    }

    void whoSavesAJobIsNotAskedAboutIt() {
        const QString job = m_folder->filePath(QStringLiteral("jobs/mine.proveout"));
        Answer answer(QStringLiteral("Cancel"));
        {
            Workstation station(false);
            station.open(m_program);
            QVERIFY(station.session.document().saveJobAs(job));
        }
        Workstation station(false);
        station.open(job);
        QCOMPARE(station.session.document().jobFile(), job);
        QCOMPARE(answer.questions().size(), 0);
    }

    void theSamplesAreOpenedWithoutAQuestion() {
        Answer answer(QStringLiteral("Cancel"));
        Workstation station(true);
        QCOMPARE(answer.questions().size(), 0);
    }

private:
    std::unique_ptr<OwnSettings> m_settings;
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_program;
    QString m_job;
};

} // namespace proveout

int main(int argc, char** argv) {
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    proveout::OutsideTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "outside_test.moc"
