// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editor/file_changed_bar.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

namespace proveout {

FileChangedBar::FileChangedBar(QWidget* parent)
    : QFrame(parent), m_text(new QLabel(this)), m_reload(new QPushButton(this)),
      m_keep(new QPushButton(this)) {
    setFrameShape(StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::ToolTipBase);
    m_text->setWordWrap(true);
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(8, 6, 8, 6);
    layout->addWidget(m_text, 0, 0, 1, 3);
    layout->addWidget(m_reload, 1, 0);
    layout->addWidget(m_keep, 1, 1);
    layout->setColumnStretch(2, 1);
    connect(m_keep, &QPushButton::clicked, this, &FileChangedBar::hide);
    connect(m_reload, &QPushButton::clicked, this, &FileChangedBar::reloadWanted);
    connect(m_keep, &QPushButton::clicked, this, &FileChangedBar::keepWanted);
    retranslate();
    hide();
}

void FileChangedBar::retranslate() {
    m_text->setText(tr("The file was changed on the disk."));
    m_reload->setText(tr("Reload"));
    m_reload->setToolTip(tr("Read the file again; changes made here are lost"));
    m_keep->setText(tr("Keep mine"));
    m_keep->setToolTip(tr("Go on with the text of this window"));
}

void FileChangedBar::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace proveout
