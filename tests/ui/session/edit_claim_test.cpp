// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/edit_claim.h"

#include <csignal>
#include <memory>
#include <sys/wait.h>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <QLockFile>
#include <QSignalSpy>
#include <QSysInfo>
#include <QTemporaryDir>
#include <QTest>

namespace proveout {

class EditClaimTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_file = m_folder->filePath(QStringLiteral("bracket.nc"));
        QFile file(m_file);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("other")));
        QVERIFY(QFile::link(m_folder->path(), m_folder->filePath(QStringLiteral("other/link"))));
    }

    void changesInAnotherWindowAreReported() {
        EditClaim first(root());
        EditClaim second(root());
        first.follow(m_file, true);
        second.follow(m_file, false);
        QVERIFY(second.other());
        QCOMPARE(second.other()->process, QCoreApplication::applicationPid());
        QCOMPARE(second.other()->computer, QSysInfo::machineHostName());
        QVERIFY(!first.other());
        second.follow(m_file, true); // edits it nevertheless
        QVERIFY(second.other());
        second.follow(QString(), false);
        QVERIFY(!second.other());
        second.follow(m_folder->filePath(QStringLiteral("other/link/bracket.nc")), false); // a link to it
        QVERIFY(second.other());
        second.follow(m_folder->filePath(QStringLiteral("else.nc")), false);
        QVERIFY(!second.other());
    }

    void whatIsSavedThereIsNoticed() {
        EditClaim first(root());
        EditClaim second(root());
        QSignalSpy changes(&second, &EditClaim::otherChanged);
        second.follow(m_file, true);
        first.follow(m_file, true);
        QVERIFY(first.other());
        QVERIFY(!second.other());
        second.follow(m_file, false);                     // saved
        QTRY_VERIFY_WITH_TIMEOUT(!first.other(), 20'000); // now the other one claims it
        QTRY_VERIFY_WITH_TIMEOUT(second.other(), 20'000);
        QCOMPARE(changes.size(), 1);
    }

    void aWindowThatIsClosedLeavesNothing() {
        {
            EditClaim first(root());
            first.follow(m_file, true);
            QCOMPARE(locks().size(), 1);
        }
        QCOMPARE(locks().size(), 0);
    }

    void aProcessThatIsGoneHasNoClaim() {
        const pid_t child = ::fork();
        if (child == 0) {
            EditClaim claim(root());
            claim.follow(m_file, true);
            ::kill(::getpid(), SIGKILL);
        }
        ::waitpid(child, nullptr, 0);
        QCOMPARE(locks().size(), 1);
        EditClaim claim(root());
        claim.follow(m_file, false);
        QVERIFY(!claim.other());
        QCOMPARE(locks().size(), 0);
    }

    /// Its process numbers have no meaning on this computer.
    void aClaimOfAnotherComputerCounts() {
        {
            EditClaim claim(root());
            claim.follow(m_file, true);
            QFile lock(root() + u'/' + locks().front());
            QVERIFY(lock.open(QIODevice::ReadOnly));
            m_content = lock.readAll();
            m_lock = lock.fileName();
        }
        QList<QByteArray> lines = m_content.split('\n'); // process, program, computer, …
        lines[0] = "1";
        lines[2] = "lathe-office";
        for (int line = 3; line < lines.size(); ++line)
            lines[line].clear(); // the lines that identify the computer
        QFile lock(m_lock);
        QVERIFY(lock.open(QIODevice::WriteOnly));
        lock.write(lines.join('\n'));
        lock.close();
        EditClaim claim(root());
        claim.follow(m_file, true);
        QVERIFY(claim.other());
        QCOMPARE(claim.other()->computer, QStringLiteral("lathe-office"));
    }

    void aFolderThatCannotBeMadeKeepsNobodyFromWorking() {
        EditClaim claim(m_file + QStringLiteral("/below"));
        claim.follow(m_file, true);
        QVERIFY(!claim.other());
    }

private:
    [[nodiscard]] QString root() const { return m_folder->filePath(QStringLiteral("claims")); }
    [[nodiscard]] QStringList locks() const { return QDir(root()).entryList(QDir::Files); }

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_file;
    QByteArray m_content;
    QString m_lock;
};

} // namespace proveout

QTEST_GUILESS_MAIN(proveout::EditClaimTest)
#include "edit_claim_test.moc"
