// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/guide_window.h"

#include <algorithm>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QEvent>
#include <QImage>
#include <QListWidget>
#include <QPainter>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTextBrowser>
#include <QTextTable>
#include <QToolBar>
#include <QVBoxLayout>

#include "ui/look/icons.h"
#include "ui/look/resource_paths.h"

namespace proveout {

namespace {

constexpr QSize kFirstSize(900, 680);
constexpr int kPagesWidth = 190;
constexpr int kTextMargin = 16;
constexpr int kCellPadding = 4;
constexpr int kWidestPicture = 640;               ///< the width of the text in the initial window
constexpr QColor kPictureFrame(0x80, 0x80, 0x80); ///< visible on a light and on a dark page
constexpr int kPageSpacing = 2;
constexpr float kTableLine = 0.3F; ///< opacity relative to the colour of the text
constexpr int kFile = Qt::UserRole;
constexpr int kId = kFile + 1;
const QString kDockPrefix = QStringLiteral("dock-");

/// Qt draws Markdown tables with double frames and without padding.
void styleTables(QTextDocument& text, const QColor& line) {
    for (QTextFrame* frame : text.rootFrame()->childFrames()) {
        auto* table = qobject_cast<QTextTable*>(frame);
        if (table == nullptr)
            continue;
        QTextTableFormat format = table->format();
        format.setBorderCollapse(true);
        format.setBorder(1);
        format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
        format.setBorderBrush(line);
        format.setCellPadding(kCellPadding);
        table->setFormat(format);
    }
}

/// Scales down images that are wider than the page and puts each in a frame, because the colours of an image
/// may be those of the page.
class GuideText final : public QTextBrowser {
public:
    using QTextBrowser::QTextBrowser;

protected:
    QVariant loadResource(int type, const QUrl& name) override {
        QVariant resource = QTextBrowser::loadResource(type, name);
        QImage picture;
        if (type != QTextDocument::ImageResource || !picture.loadFromData(resource.toByteArray()))
            return resource;
        const qreal density = devicePixelRatioF();
        if (picture.width() > kWidestPicture) {
            picture =
                picture.scaledToWidth(static_cast<int>(kWidestPicture * density), Qt::SmoothTransformation);
            picture.setDevicePixelRatio(density);
        }
        picture.convertTo(QImage::Format_RGB32); // QPainter cannot paint on an image with a palette
        QPainter painter(&picture);
        painter.setPen(kPictureFrame);
        painter.drawRect(QRectF(QPointF(0, 0), picture.deviceIndependentSize() - QSizeF(1, 1)));
        return picture;
    }
};

} // namespace

GuideWindow::GuideWindow(QWidget* parent)
    : QWidget(parent, Qt::Window), m_tools(new QToolBar(this)), m_pages(new QListWidget(this)),
      m_text(new GuideText(this)), m_back(new QAction(this)), m_forward(new QAction(this)) {
    setObjectName(QStringLiteral("guide"));
    m_pages->setObjectName(QStringLiteral("guide-pages"));
    m_text->setObjectName(QStringLiteral("guide-text"));
    m_pages->setSpacing(kPageSpacing);
    m_text->setOpenExternalLinks(true);
    m_text->document()->setDocumentMargin(kTextMargin);
    auto* split = new QSplitter(this);
    split->addWidget(m_pages);
    split->addWidget(m_text);
    split->setStretchFactor(1, 1);
    split->setSizes({kPagesWidth, kFirstSize.width() - kPagesWidth});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_tools);
    layout->addWidget(split, 1);
    resize(kFirstSize);
    makeTools();
    listPages();
    retranslate();
    connect(m_pages, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
        if (item != nullptr && item->data(kFile).toUrl().fileName() != m_text->source().fileName())
            m_text->setSource(item->data(kFile).toUrl(), QTextDocument::MarkdownResource);
    });
    connect(m_text, &QTextBrowser::sourceChanged, this, &GuideWindow::followText);
}

void GuideWindow::makeTools() {
    m_tools->setIconSize({16, 16});
    m_back->setShortcut(QKeySequence::Back);
    m_forward->setShortcut(QKeySequence::Forward);
    connect(m_back, &QAction::triggered, m_text, &QTextBrowser::backward);
    connect(m_forward, &QAction::triggered, m_text, &QTextBrowser::forward);
    connect(m_text, &QTextBrowser::backwardAvailable, m_back, &QAction::setEnabled);
    connect(m_text, &QTextBrowser::forwardAvailable, m_forward, &QAction::setEnabled);
    for (QAction* action : {m_back, m_forward}) {
        action->setEnabled(false);
        m_tools->addAction(action);
    }
    auto* close = new QAction(this);
    close->setShortcuts({QKeySequence(Qt::Key_Escape), QKeySequence::Close});
    connect(close, &QAction::triggered, this, &QWidget::close);
    addAction(close);
}

void GuideWindow::listPages() {
    for (const GuidePage& page : guidePages()) {
        auto* item = new QListWidgetItem(page.title, m_pages);
        item->setData(kFile, QUrl::fromLocalFile(page.file));
        item->setData(kId, page.id);
    }
}

void GuideWindow::showPage(const QString& page) {
    int row = 0;
    for (int i = 0; i < m_pages->count(); ++i) {
        if (m_pages->item(i)->data(kId).toString() == page)
            row = i;
    }
    m_pages->setCurrentRow(row);
    show();
    raise();
    activateWindow();
    m_text->setFocus();
}

/// A link has opened another page.
void GuideWindow::followText(const QUrl& shown) {
    styleText();
    const QSignalBlocker quiet(m_pages);
    for (int i = 0; i < m_pages->count(); ++i) {
        if (m_pages->item(i)->data(kFile).toUrl().fileName() == shown.fileName())
            m_pages->setCurrentRow(i);
    }
}

void GuideWindow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::PaletteChange)
        styleText();
    QWidget::changeEvent(event);
}

void GuideWindow::styleText() {
    QColor line = palette().color(QPalette::Text);
    line.setAlphaF(kTableLine);
    styleTables(*m_text->document(), line);
}

void GuideWindow::retranslate() {
    setWindowTitle(tr("User Guide – Proveout"));
    m_back->setText(tr("← Back"));
    m_forward->setText(tr("Forward →"));
    m_pages->setAccessibleName(tr("User guide pages"));
    m_text->setAccessibleName(tr("User guide page"));
}

QString guidePageOf(const QWidget* widget) {
    for (; widget != nullptr; widget = widget->parentWidget()) {
        if (qobject_cast<const QDockWidget*>(widget) != nullptr)
            return widget->objectName().mid(kDockPrefix.size());
    }
    return QStringLiteral("index");
}

void openGuide(QWidget& window, const QWidget& view, bool hasView) {
    const QWidget* focused = QApplication::focusWidget();
    const bool onView = hasView && focused != nullptr && (focused == &view || view.isAncestorOf(focused));
    auto* guide = window.findChild<GuideWindow*>();
    if (guide == nullptr)
        guide = new GuideWindow(&window);
    guide->showPage(onView ? QStringLiteral("view") : guidePageOf(focused));
}

} // namespace proveout
