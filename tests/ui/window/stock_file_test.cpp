// SPDX-License-Identifier: GPL-3.0-or-later
// The file that the stock was read from: changed by another program, and overwritten by this one.
#include <algorithm>
#include <functional>
#include <memory>
#include <string_view>

#include <QApplication>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include "core/formats/stock_shapes.h"
#include "tests/ui/window/workstation.h"
#include "ui/document/file_paths.h"
#include "ui/setup/stock_changed_bar.h"

namespace proveout {
namespace {

const QByteArray kProgram = "G21 G90\nT1 M6\nG0 X-5 Y10 Z5\nG1 Z-2 F500\nX45\nZ-4\nX-5\nG0 Z5\nM30\n";

QByteArray read(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void write(const QString& path, const QByteArray& bytes) {
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
        qFatal("%s cannot be written", qPrintable(path));
}

/// Answers dialogs while it exists: a file dialog with a name, questions with their buttons.
class Answers {
public:
    Answers(QString file, QStringList buttons) : m_file(std::move(file)), m_buttons(std::move(buttons)) {
        QObject::connect(&m_look, &QTimer::timeout, [this] { act(QApplication::activeModalWidget()); });
        m_look.start(20);
    }
    [[nodiscard]] const QStringList& questions() const { return m_questions; }

private:
    void act(QWidget* widget) {
        if (auto* dialog = qobject_cast<QFileDialog*>(widget); dialog != nullptr && !m_named) {
            m_named = true;
            dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(m_file);
            auto* buttons = dialog->findChild<QDialogButtonBox*>();
            QMetaObject::invokeMethod(buttons->button(QDialogButtonBox::Save), "click", Qt::QueuedConnection);
        } else if (auto* box = qobject_cast<QMessageBox*>(widget); box != nullptr && !m_buttons.isEmpty()) {
            m_questions << box->text() + u'\n' + box->informativeText();
            const QString wanted = m_buttons.takeFirst();
            for (QAbstractButton* each : box->buttons())
                if (each->text().remove(u'&') == wanted)
                    QMetaObject::invokeMethod(each, "click", Qt::QueuedConnection);
        }
    }

    QString m_file;
    QStringList m_buttons;
    QStringList m_questions;
    bool m_named = false;
    QTimer m_look;
};

/// A window with a job whose stock was left by an earlier setup.
struct Bench {
    QTemporaryDir folder;
    QString stock = folder.filePath(QStringLiteral("blank.pvstock"));
    QByteArray first; ///< content of that file
    QByteArray deeper;
    Workstation station{false};
    Session& session = station.session;

    Bench() {
        const QString program = folder.filePath(QStringLiteral("p.nc"));
        write(program, kProgram);
        station.open(program);
        Setup setup = session.job().setup();
        setup.tools.set(1, parseCutter("flat:d=4,l=20").value());
        setup.stock = {Vec3(0), 40, 20, 10};
        setup.automaticGrid = false;
        setup.spacing = 1;
        if (!session.job().setSetup(setup))
            qFatal("the setup is refused");
        first = saved(3);
        deeper = saved(5);
        write(stock, first);
        startFromFile();
        auto* dock = station.window.findChild<QDockWidget*>(QStringLiteral("dock-setup"));
        dock->show();
        dock->raise();
        if (!session.document().saveJobAs(folder.filePath(QStringLiteral("p.proveout"))))
            qFatal("the job cannot be saved");
    }
    [[nodiscard]] bool hasProblem() const {
        return std::ranges::any_of(session.problems().all(), [](const Diagnostic& problem) {
            return std::string_view(problem.id) == "stock-changed-on-disk";
        });
    }
    [[nodiscard]] StockChangedBar& bar() const { return *station.window.findChild<StockChangedBar*>(); }
    [[nodiscard]] QString reported() const { return bar().findChild<QLabel*>()->text(); }
    void press(const char* button) const {
        QTest::mouseClick(bar().findChild<QPushButton*>(QLatin1String(button)), Qt::LeftButton);
    }
    /// Height of the uncut stock in the slot that an earlier setup has cut.
    [[nodiscard]] double heightInSlot() const {
        return session.simulation().frame() == nullptr ? 0.0
                                                       : session.simulation().frame()->zmap.height(20, 10);
    }
    /// Seeks to a block like the view.
    bool seek(std::size_t block) const {
        session.playback().seek(block);
        return QTest::qWaitFor(
            [&] {
                const FramePtr& frame = session.simulation().frame();
                return frame && frame->setup.get() == session.document().job().setup().get() &&
                       frame->block == block;
            },
            kPatience);
    }

private:
    /// The saved stock after the given number of blocks.
    QByteArray saved(std::size_t blocks) {
        if (!seek(blocks))
            qFatal("the program does not run");
        QSignalSpy exported(&session.exports(), &ExportHub::exported);
        session.exports().saveStock(stock);
        if (!QTest::qWaitFor([&] { return !exported.isEmpty(); }, kPatience))
            qFatal("the stock is not saved");
        return read(stock);
    }
    void startFromFile() {
        StockSpec spec;
        spec.shape.kind = StockKind::saved;
        spec.shape.file = toPath(stock);
        if (!makeStock(spec, std::nullopt))
            qFatal("the stock cannot be read");
        Setup setup = session.job().setup();
        setup.stock = spec.box;
        setup.shape = spec.shape;
        if (!session.job().setSetup(setup) || !seek(0))
            qFatal("the stock is refused");
    }
};

} // namespace

class StockFileTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs); }
    void init() { m_settings = std::make_unique<OwnSettings>(); }

    void aStockThatAnotherProgramChangesIsReportedAndReadAgain() {
        Bench bench;
        QVERIFY(bench.bar().isHidden());
        QCOMPARE(bench.heightInSlot(), -2.0);
        QVERIFY(bench.first != bench.deeper);
        write(bench.stock, bench.deeper);
        QTRY_VERIFY_WITH_TIMEOUT(bench.bar().isVisible(), kPatience);
        QVERIFY2(bench.reported().startsWith(QStringLiteral("blank.pvstock has changed on disk.")),
                 qPrintable(bench.reported()));
        QVERIFY(bench.hasProblem());
        QCOMPARE(bench.heightInSlot(), -2.0); // as displayed
        bench.press("stock-reload");
        QTRY_COMPARE_WITH_TIMEOUT(bench.heightInSlot(), -4.0, kPatience);
        QVERIFY(bench.bar().isHidden());
        QVERIFY(!bench.hasProblem());
        QVERIFY(!bench.session.document().modified()); // the job still names the same file
    }

    void keptItStaysUntilItIsChangedAgain() {
        Bench bench;
        write(bench.stock, bench.deeper);
        QTRY_VERIFY_WITH_TIMEOUT(bench.bar().isVisible(), kPatience);
        bench.press("stock-keep");
        QVERIFY(bench.bar().isHidden());
        QVERIFY(!bench.hasProblem());
        Setup setup = bench.session.job().setup();
        setup.tools.set(2, parseCutter("flat:d=6").value());
        QVERIFY(bench.session.job().setSetup(setup).has_value());
        QTest::qWait(600);
        QVERIFY(bench.bar().isHidden()); // there was no new change
        QCOMPARE(bench.heightInSlot(), -2.0);
        QVERIFY(QFile::remove(bench.stock));
        QTRY_VERIFY_WITH_TIMEOUT(bench.bar().isVisible(), kPatience);
        QVERIFY2(bench.reported().contains(QStringLiteral("was deleted or renamed")),
                 qPrintable(bench.reported()));
        QVERIFY(bench.bar().findChild<QPushButton*>(QStringLiteral("stock-reload"))->isHidden());
        bench.session.document().newFile(); // another document is not affected
        QVERIFY(bench.bar().isHidden());
        QVERIFY(!bench.hasProblem());
    }

    void itIsNotOverwrittenByItsOwnResultWithoutAQuestion_data() {
        QTest::addColumn<QString>("button");
        QTest::addRow("cancel") << QStringLiteral("Cancel");
        QTest::addRow("overwrite") << QStringLiteral("Overwrite");
    }

    void itIsNotOverwrittenByItsOwnResultWithoutAQuestion() {
        QFETCH(QString, button);
        Bench bench;
        QVERIFY(bench.seek(bench.session.program().blockCount()));
        // Under another name of the same file.
        const QString link = bench.folder.filePath(QStringLiteral("other.pvstock"));
        QVERIFY(QFile::link(bench.stock, link));
        Answers answers(link, {QStringLiteral("Yes"), button});
        bench.station.window.action(QStringLiteral("file-save-stock"))->trigger();
        QCOMPARE(answers.questions().size(), 2); // the first is that of the file dialog
        QVERIFY2(answers.questions().back().contains(QStringLiteral("is the stock of the open job")),
                 qPrintable(answers.questions().back()));
        if (button == QStringLiteral("Cancel")) {
            QVERIFY(!bench.session.exports().isRunning());
            QCOMPARE(read(bench.stock), bench.first);
            return;
        }
        QTRY_VERIFY_WITH_TIMEOUT(read(bench.stock) != bench.first || read(link) != bench.first, kPatience);
    }

private:
    std::unique_ptr<OwnSettings> m_settings;
};

} // namespace proveout

int main(int argc, char** argv) {
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    proveout::StockFileTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "stock_file_test.moc"
