// SPDX-License-Identifier: GPL-3.0-or-later
// The user guide opens at the page about the focused widget, and its links stay within it.
#include <algorithm>
#include <memory>
#include <set>

#include <QAbstractSpinBox>
#include <QApplication>
#include <QDockWidget>
#include <QFile>
#include <QImage>
#include <QListWidget>
#include <QScrollBar>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>

#include "core/formats/formats.h"
#include "core/formats/stock_shapes.h"
#include "core/nc/codes/dialects.h"
#include "tests/ui/window/workstation.h"
#include "ui/editor/editor_panel.h"
#include "ui/editor/nc_editor.h"
#include "ui/look/resource_paths.h"
#include "ui/window/guide_window.h"

namespace proveout {
namespace {

QString pageShown(const GuideWindow& guide) {
    return guide.findChild<QTextBrowser*>()->source().fileName();
}

QStringList picturesOf(const QTextDocument& text) {
    QStringList names;
    for (QTextBlock block = text.begin(); block.isValid(); block = block.next())
        for (auto part = block.begin(); !part.atEnd(); ++part)
            if (part.fragment().charFormat().isImageFormat())
                names << part.fragment().charFormat().toImageFormat().name();
    return names;
}

/// Presses F1 in the focused widget.
GuideWindow& guideFor(Workstation& station, QWidget& focused) {
    station.activate();
    focused.setFocus();
    const auto arrived = [&focused] {
        const QWidget* now = QApplication::focusWidget();
        return now != nullptr &&
               (now == &focused || focused.isAncestorOf(now) || now == focused.focusProxy());
    };
    if (!QTest::qWaitFor(arrived, kPatience))
        qFatal("the widget does not get the focus");
    QTest::keyClick(&station.window, Qt::Key_F1);
    return *station.window.findChild<GuideWindow*>();
}

} // namespace

class GuideTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_settings = std::make_unique<OwnSettings>(); }

    void everyPanelHasAPage() {
        Workstation station(false);
        std::set<QString> pages;
        for (const GuidePage& page : guidePages()) {
            pages.insert(page.id);
            QVERIFY2(!page.title.isEmpty(), qPrintable(page.id));
        }
        for (const QDockWidget* dock : station.window.findChildren<QDockWidget*>())
            QVERIFY2(pages.contains(guidePageOf(dock)), qPrintable(dock->objectName()));
        QVERIFY(pages.contains(QStringLiteral("view")) && pages.contains(QStringLiteral("index")));
    }

    /// Pages that list the rows of a table must name all of them.
    void pagesNameEveryRowOfTheTables() {
        const auto page = [](const char* name) {
            const std::vector<GuidePage> pages = guidePages();
            const auto row = std::ranges::find(pages, QLatin1String(name), &GuidePage::id);
            QFile file(row == pages.end() ? QString() : row->file);
            return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
        };
        const QString reads = page("reads");
        for (const Dialect& row : dialects())
            QVERIFY2(reads.contains(QStringLiteral("| %1 |").arg(QLatin1String(row.name))), row.name);
        const QString files = page("files");
        for (const FileFormat& row : fileFormats()) {
            const QString ending = QLatin1String(row.extensions.front() + 1);
            const bool mesh = row.meshWriter() != nullptr;
            QVERIFY2(!mesh || files.contains(ending.toUpper()), row.key);
        }
        const QString setup = page("setup");
        for (const StockShapeRow& row : stockShapes())
            QVERIFY2(setup.contains(QStringLiteral("*%1*").arg(QLatin1String(row.label))), row.label);
    }

    void opensAtThePanelThatHasTheFocus() {
        Workstation station(true);
        GuideWindow& guide = guideFor(station, station.window.editor().editor());
        QVERIFY(guide.isVisible());
        QCOMPARE(pageShown(guide), QStringLiteral("program.md"));
        QCOMPARE(&guideFor(station, station.window.viewport()), &guide); // the same window
        QCOMPARE(pageShown(guide), QStringLiteral("view.md"));
        auto* setup = station.window.findChild<QDockWidget*>(QStringLiteral("dock-setup"));
        setup->raise();
        const auto fields = setup->findChildren<QAbstractSpinBox*>();
        const auto shown =
            std::ranges::find_if(fields, [](const QWidget* field) { return field->isVisible(); });
        QVERIFY(shown != fields.end());
        guideFor(station, **shown);
        QCOMPARE(pageShown(guide), QStringLiteral("setup.md"));
    }

    void aLinkLeadsToItsPage() {
        Workstation station(false);
        station.activate();
        QTest::keyClick(&station.window, Qt::Key_F1);
        GuideWindow& guide = *station.window.findChild<GuideWindow*>();
        QCOMPARE(pageShown(guide), QStringLiteral("index.md"));
        auto* text = guide.findChild<QTextBrowser*>();
        QVERIFY(text->toMarkdown().contains(QLatin1String("(setup.md)")));
        text->setSource(QUrl(QStringLiteral("setup.md")));
        QCOMPARE(pageShown(guide), QStringLiteral("setup.md"));
        QVERIFY(text->toPlainText().size() > 500);
        const auto* pages = guide.findChild<QListWidget*>();
        QCOMPARE(pages->currentItem()->text(), text->document()->firstBlock().text());
        text->backward();
        QCOMPARE(pageShown(guide), QStringLiteral("index.md"));
    }

    void pagesShowTheirPictures() {
        Workstation station(false);
        station.activate();
        QTest::keyClick(&station.window, Qt::Key_F1);
        GuideWindow& guide = *station.window.findChild<GuideWindow*>();
        const auto* text = guide.findChild<QTextBrowser*>();
        int pictures = 0;
        for (const GuidePage& page : guidePages()) {
            guide.showPage(page.id);
            for (const QString& name : picturesOf(*text->document())) {
                ++pictures;
                const auto picture =
                    text->document()->resource(QTextDocument::ImageResource, QUrl(name)).value<QImage>();
                QVERIFY2(!picture.isNull(), qPrintable(page.id + QStringLiteral(" shows no ") + name));
            }
            QVERIFY2(text->horizontalScrollBar()->maximum() == 0, qPrintable(page.id));
        }
        QVERIFY(pictures >= 5);
    }

private:
    std::unique_ptr<OwnSettings> m_settings;
};

} // namespace proveout

int main(int argc, char** argv) {
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    proveout::GuideTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "guide_test.moc"
