// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/edited_elsewhere_bar.h"

#include <QEvent>
#include <QFileInfo>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/document/file_paths.h"

namespace proveout {

EditedElsewhereBar::EditedElsewhereBar(Session& session, FilePart part, QWidget* parent)
    : QFrame(parent), m_session(session), m_part(part), m_claim(EditClaim::defaultRoot()),
      m_text(new QLabel(this)) {
    setFrameShape(StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::ToolTipBase);
    m_text->setForegroundRole(QPalette::ToolTipText);
    m_text->setTextFormat(Qt::PlainText); // the name comes from the user
    m_text->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 6, 8, 6);
    layout->addWidget(m_text);
    hide();
    connect(&session.document(), &DocumentHub::changed, this, &EditedElsewhereBar::follow);
    connect(&m_claim, &EditClaim::otherChanged, this, &EditedElsewhereBar::showOther);
    follow();
}

QString EditedElsewhereBar::file() const {
    return m_part == FilePart::text ? toQString(m_session.document().text().path)
                                    : m_session.document().jobFile();
}

void EditedElsewhereBar::follow() {
    m_claim.follow(file(), m_part == FilePart::text ? m_session.document().text().modified
                                                    : m_session.document().jobModified());
    showOther();
}

void EditedElsewhereBar::showOther() {
    if (const auto& other = m_claim.other())
        m_text->setText(
            tr("%1 has unsaved changes in another Proveout window (process %2 on %3). Save or "
               "discard them there before you edit the file here.")
                .arg(QFileInfo(file()).fileName(), QString::number(other->process), other->computer));
    setVisible(m_claim.other().has_value());
}

void EditedElsewhereBar::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        showOther();
}

} // namespace proveout
