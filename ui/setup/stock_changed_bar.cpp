// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/setup/stock_changed_bar.h"

#include <QEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include "ui/document/file_paths.h"

namespace proveout {

StockChangedBar::StockChangedBar(Session& session, QWidget* parent)
    : QFrame(parent), m_session(session), m_text(new QLabel(this)), m_reload(new QPushButton(this)),
      m_keep(new QPushButton(this)) {
    m_reload->setObjectName(QStringLiteral("stock-reload"));
    m_keep->setObjectName(QStringLiteral("stock-keep"));
    setFrameShape(StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::ToolTipBase);
    m_text->setForegroundRole(QPalette::ToolTipText);
    m_text->setTextFormat(Qt::PlainText); // the name comes from the user
    m_text->setWordWrap(true);
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(8, 6, 8, 6);
    layout->addWidget(m_text, 0, 0, 1, 3);
    layout->addWidget(m_reload, 1, 0);
    layout->addWidget(m_keep, 1, 1);
    layout->setColumnStretch(2, 1);
    connect(m_reload, &QPushButton::clicked, &session.stockFile(), &StockFileHub::reload);
    connect(m_keep, &QPushButton::clicked, &session.stockFile(), &StockFileHub::keep);
    connect(&session.stockFile(), &StockFileHub::changedOnDisk, this, [this](bool changed) {
        writeSentence();
        setVisible(changed);
    });
    retranslate();
    hide();
}

void StockChangedBar::writeSentence() {
    const QFileInfo info(toQString(m_session.job().setup().shape.file));
    const bool readable = info.isFile();
    m_reload->setVisible(readable);
    m_text->setText((readable
                         ? tr("%1 has changed on disk. The simulation still uses the version read before.")
                         : tr("%1 was deleted or renamed on disk. The simulation still uses the version read "
                              "before, but the job cannot be opened without the file."))
                        .arg(info.fileName()));
}

void StockChangedBar::retranslate() {
    m_reload->setText(tr("&Reload"));
    m_reload->setToolTip(tr("Read the stock again and simulate with it"));
    m_keep->setText(tr("&Keep This Version"));
    m_keep->setToolTip(tr("Continue with the stock read before"));
    writeSentence();
}

void StockChangedBar::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace proveout
