// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/start_page.h"

#include <QComboBox>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/look/icons.h"
#include "ui/look/panel_layout.h"
#include "ui/look/resource_paths.h"

namespace proveout {

namespace {

constexpr int kColumnWidth = 220;
constexpr int kColumnGap = 32;
constexpr double kTitleScale = 2.4;
constexpr int kLogoSize = 56;

void clear(QVBoxLayout& layout) {
    while (QLayoutItem* item = layout.takeAt(0)) {
        item->widget()->hide();
        item->widget()->deleteLater(); // it may be the button whose click opened a file
        delete item;
    }
}

} // namespace

StartPage::StartPage(Appearance& appearance, RecentFiles& recent, QWidget* parent)
    : QWidget(parent), m_appearance(appearance), m_recent(recent), m_logo(new QLabel(this)),
      m_title(new QLabel(this)), m_subtitle(new QLabel(this)), m_open(new QPushButton(this)),
      m_new(new QPushButton(this)), m_back(new QPushButton(this)) {
    m_logo->setPixmap(icon(QStringLiteral("proveout")).pixmap(kLogoSize, kLogoSize));
    QFont large = m_title->font();
    large.setPointSizeF(large.pointSizeF() * kTitleScale);
    large.setWeight(QFont::DemiBold);
    m_title->setFont(large);
    m_subtitle->setForegroundRole(QPalette::PlaceholderText);
    m_open->setIcon(icon(QStringLiteral("open")));
    m_new->setIcon(icon(QStringLiteral("new")));
    m_open->setDefault(true);
    m_back->setObjectName(QStringLiteral("back"));
    m_back->setShortcut(Qt::Key_Escape);
    m_back->hide();
    connect(m_back, &QPushButton::clicked, this, &StartPage::backWanted);
    connect(m_open, &QPushButton::clicked, this, &StartPage::openWanted);
    connect(m_new, &QPushButton::clicked, this, &StartPage::newWanted);
    connect(&recent, &RecentFiles::changed, this, &StartPage::refresh);

    auto* names = new QVBoxLayout;
    names->setSpacing(2);
    names->addWidget(m_title);
    names->addWidget(m_subtitle);
    auto* head = new QHBoxLayout;
    head->setSpacing(16);
    head->addWidget(m_logo);
    head->addLayout(names);
    head->addStretch(1);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_open);
    buttons->addWidget(m_new);
    buttons->addWidget(m_back);
    buttons->addStretch(1);
    auto* columns = new QHBoxLayout;
    columns->setSpacing(kColumnGap);
    columns->addWidget(makeSamples(), 0, Qt::AlignTop);
    columns->addWidget(makeRecent(), 0, Qt::AlignTop);

    auto* block = new QVBoxLayout;
    block->addLayout(head);
    block->addSpacing(20);
    block->addLayout(buttons);
    block->addSpacing(28);
    block->addLayout(columns);
    block->addSpacing(24);
    block->addWidget(makeFooter());
    auto* middle = new QHBoxLayout;
    middle->addStretch(1);
    middle->addLayout(block);
    middle->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->addStretch(2);
    layout->addLayout(middle);
    layout->addStretch(3);
    retranslate();
}

QWidget* StartPage::makeSamples() {
    auto* column = new QWidget(this);
    column->setMinimumWidth(kColumnWidth);
    auto* layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 0, 0, 0);
    m_samplesTitle = sectionLabel(column);
    m_samples = new QVBoxLayout;
    m_samples->setSpacing(2);
    layout->addWidget(m_samplesTitle);
    layout->addLayout(m_samples);
    return column;
}

QWidget* StartPage::makeRecent() {
    auto* column = new QWidget(this);
    column->setMinimumWidth(kColumnWidth);
    auto* layout = new QVBoxLayout(column);
    layout->setContentsMargins(0, 0, 0, 0);
    m_recentTitle = sectionLabel(column);
    m_recentList = new QVBoxLayout;
    m_recentList->setSpacing(2);
    layout->addWidget(m_recentTitle);
    layout->addLayout(m_recentList);
    return column;
}

QWidget* StartPage::makeFooter() {
    auto* footer = new QWidget(this);
    auto* layout = new QHBoxLayout(footer);
    layout->setContentsMargins(0, 0, 0, 0);
    m_dropHint = wrappedLabel(footer);
    m_dropHint->setForegroundRole(QPalette::PlaceholderText);
    m_languageLabel = new QLabel(footer);
    m_language = new QComboBox(footer);
    m_languageLabel->setBuddy(m_language);
    for (const Language& language : languages())
        m_language->addItem(language.name, language.code);
    connect(m_language, &QComboBox::activated, this,
            [this](int index) { m_appearance.setLanguage(m_language->itemData(index).toString()); });
    layout->addWidget(m_dropHint, 1);
    layout->addWidget(m_languageLabel);
    layout->addWidget(m_language);
    return footer;
}

QPushButton* StartPage::addFile(QVBoxLayout& column, const QString& text, const QString& file) {
    auto* button = new QPushButton(text, this);
    button->setFlat(true);
    button->setIcon(icon(QFileInfo(file).suffix() == QLatin1String("proveout") ? QStringLiteral("stock")
                                                                               : QStringLiteral("path")));
    button->setToolTip(file);
    button->setCursor(Qt::PointingHandCursor);
    button->setStyleSheet(QStringLiteral("QPushButton { text-align: left; padding: 5px 6px; }"));
    connect(button, &QPushButton::clicked, this, [this, file] { emit fileWanted(file); });
    column.addWidget(button);
    return button;
}

void StartPage::refresh() {
    clear(*m_samples);
    clear(*m_recentList);
    for (const SampleJob& sample : sampleJobs())
        addFile(*m_samples, sample.name, sample.file);
    for (const QString& file : m_recent.files()) {
        const QString name =
            fontMetrics().elidedText(QFileInfo(file).fileName(), Qt::ElideMiddle, kColumnWidth - 20);
        QPushButton* button = addFile(*m_recentList, name, file);
        if (!m_recent.isMissing(file))
            continue;
        button->setText(tr("%1 (missing)").arg(name));
        button->setToolTip(tr("%1\nFile not found.").arg(file));
        button->setEnabled(false);
    }
    m_recentTitle->setVisible(!m_recent.files().isEmpty());
}

void StartPage::setOpenDocument(const QString& name) {
    m_openDocument = name;
    m_back->setVisible(!name.isEmpty());
    m_back->setText(tr("Back to %1").arg(name).replace(u'&', QLatin1String("&&")));
    m_back->setShortcut(Qt::Key_Escape); // setting a text removes the shortcut
}

void StartPage::retranslate() {
    m_title->setText(QStringLiteral("Proveout"));
    m_subtitle->setText(tr("See what an NC program cuts before the machine does."));
    m_open->setText(tr("Open File…"));
    m_open->setToolTip(tr("Open an NC program or a job"));
    m_new->setText(tr("New Program"));
    m_new->setToolTip(tr("Create an empty NC program"));
    m_back->setToolTip(tr("Go back to the open document (Esc)"));
    setOpenDocument(m_openDocument);
    m_samplesTitle->setText(tr("Samples"));
    m_recentTitle->setText(tr("Recent files"));
    m_dropHint->setText(tr("Or drop a file anywhere on this window."));
    m_languageLabel->setText(tr("Language"));
    m_language->setToolTip(tr("Language of the user interface"));
    m_language->setCurrentIndex(m_language->findData(m_appearance.language()));
    refresh();
}

void StartPage::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

void StartPage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    m_recent.look();
}

} // namespace proveout
