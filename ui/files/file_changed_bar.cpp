// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/file_changed_bar.h"

#include <QEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "ui/document/file_paths.h"
#include "ui/files/compare_dialog.h"

namespace proveout {

FileChangedBar::FileChangedBar(Session& session, FilePart part, QWidget* parent)
    : QFrame(parent), m_session(session), m_part(part), m_text(new QLabel(this)),
      m_reload(new QPushButton(this)), m_keep(new QPushButton(this)), m_compare(new QPushButton(this)) {
    setFrameShape(StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::ToolTipBase);
    m_text->setForegroundRole(QPalette::ToolTipText);
    m_text->setTextFormat(Qt::PlainText); // the name comes from the user
    m_text->setWordWrap(true);
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(8, 6, 8, 6);
    layout->addWidget(m_text, 0, 0, 1, 4);
    layout->addWidget(m_reload, 1, 0);
    layout->addWidget(m_keep, 1, 1);
    layout->addWidget(m_compare, 1, 2);
    layout->setColumnStretch(3, 1);
    connect(m_reload, &QPushButton::clicked, this, &FileChangedBar::reload);
    connect(m_keep, &QPushButton::clicked, this, &FileChangedBar::keep);
    connect(m_compare, &QPushButton::clicked, this, &FileChangedBar::compare);
    connect(&session.document(), &DocumentHub::changed, this, &FileChangedBar::writeSentence);
    if (part == FilePart::text) {
        connect(&session.document(), &DocumentHub::fileChangedOnDisk, this, &FileChangedBar::report);
        connect(&session.document(), &DocumentHub::fileWritten, this, &QWidget::hide);
        connect(&session.document(), &DocumentHub::textReplaced, this, &QWidget::hide);
    } else {
        connect(&session.document(), &DocumentHub::jobChangedOnDisk, this,
                [this](bool changed) { changed ? report() : hide(); });
    }
    retranslate();
    hide();
}

QString FileChangedBar::file() const {
    return m_part == FilePart::text ? toQString(m_session.document().text().path)
                                    : m_session.document().jobFile();
}

void FileChangedBar::report() {
    writeSentence();
    show();
}

void FileChangedBar::writeSentence() {
    const QFileInfo info(file());
    const bool readable = info.isFile();
    const bool modified =
        m_part == FilePart::text ? m_session.document().text().modified : m_session.document().jobModified();
    m_reload->setVisible(readable);
    m_compare->setVisible(readable);
    if (!info.exists())
        m_text->setText(
            tr("%1 was deleted or renamed on disk. Saving creates it again.").arg(info.fileName()));
    else if (!readable)
        m_text->setText(tr("%1 is no longer a file. Save under another name.").arg(info.fileName()));
    else if (modified)
        m_text->setText(
            tr("%1 has changed on disk. Reloading discards your unsaved changes.").arg(info.fileName()));
    else
        m_text->setText(tr("%1 has changed on disk.").arg(info.fileName()));
}

void FileChangedBar::reload() {
    if (m_part == FilePart::text)
        m_session.document().reload();
    else
        m_session.document().reloadJob();
}

void FileChangedBar::keep() {
    hide();
    if (m_part == FilePart::text)
        m_session.document().keepMine();
    else
        m_session.document().keepMyJob();
}

void FileChangedBar::compare() {
    if (const auto conflict = m_session.document().conflict(m_part))
        CompareDialog({comparisonOf(*conflict)}, this).exec();
    else
        hide(); // the change was reverted on disk
}

void FileChangedBar::retranslate() {
    m_reload->setText(tr("&Reload"));
    m_reload->setToolTip(tr("Read the file again; your unsaved changes are lost"));
    m_keep->setText(tr("&Keep My Version"));
    m_keep->setToolTip(tr("Continue with the version in this window"));
    m_compare->setText(tr("&Compare…"));
    m_compare->setToolTip(tr("Show the differences between the file and this window"));
    writeSentence();
}

void FileChangedBar::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace proveout
