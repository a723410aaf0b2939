// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/job_document.h"

#include <atomic>
#include <barrier>
#include <memory>
#include <string_view>
#include <thread>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "ui/document/file_paths.h"

namespace proveout {

class JobDocumentTest : public QObject {
    Q_OBJECT

private slots:
    /// Two windows save the file that both have read at the same moment: one of them must be refused.
    void ofTwoThatSaveAtOnceOneIsRefused() {
        constexpr int kRounds = 40;
        QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("bracket.nc"));
        const QString jobFile = folder.filePath(QStringLiteral("bracket.proveout"));
        for (int round = 0; round < kRounds; ++round) {
            QFile program(file);
            QVERIFY(program.open(QIODevice::WriteOnly));
            program.write("G0 X1\n");
            program.close();
            auto first = JobDocument::open(file);
            QVERIFY(first);
            QVERIFY(first->saveJobAs(jobFile));
            auto second = JobDocument::open(jobFile);
            QVERIFY(second);
            QCOMPARE(atOnce(*first, *second,
                            [](JobDocument& document, char mark) {
                                document.edit(0, 0, std::string_view(&mark, 1));
                                document.setTextModified(true);
                            }),
                     1);
            QCOMPARE(atOnce(*first, *second,
                            [](JobDocument& document, char mark) {
                                Setup setup = *document.setup();
                                setup.startTool = mark;
                                document.setSetup(std::make_shared<const Setup>(setup));
                                document.setTextModified(false);
                            }),
                     1);
        }
    }

private:
    /// The number of successful saves.
    template<class Change>
    static int atOnce(JobDocument& first, JobDocument& second, const Change& change) {
        std::barrier start(2);
        std::atomic<int> saved = 0;
        const auto save = [&](JobDocument& document, char mark) {
            change(document, mark);
            start.arrive_and_wait();
            saved += document.save() ? 1 : 0;
        };
        std::thread other([&] { save(second, 'B'); });
        save(first, 'A');
        other.join();
        return saved;
    }
};

} // namespace proveout

QTEST_GUILESS_MAIN(proveout::JobDocumentTest)
#include "job_document_test.moc"
