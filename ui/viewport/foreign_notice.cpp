// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/foreign_notice.h"

#include "core/nc/codes/dialects.h"
#include <QEvent>
#include <QHBoxLayout>
#include <QMenu>
#include <QPushButton>

#include "ui/look/diagnostic_text.h"
#include "ui/session/session.h"

namespace proveout {

ForeignNotice::ForeignNotice(Session& session, QWidget* parent)
    : ViewNotice(parent), m_session(session), m_readAs(new QPushButton(this)), m_dialects(new QMenu(this)) {
    setObjectName(QStringLiteral("foreignNotice"));
    m_readAs->setObjectName(QStringLiteral("foreignNoticeReadAs"));
    for (const Dialect& row : dialects())
        m_dialects->addAction(QString::fromUtf8(row.name), this,
                              [this, id = row.id] { m_session.job().asOneStep([this, id] { readAs(id); }); });
    m_readAs->setMenu(m_dialects);
    buttonRow().addWidget(m_readAs);
    connect(&session.program(), &ProgramHub::changed, this, &ForeignNotice::showState);
    showState();
}

void ForeignNotice::readAs(DialectId dialect) {
    Setup setup = m_session.job().setup();
    setup.dialect = dialect;
    if (const auto done = m_session.job().setSetup(setup); !done)
        m_session.problems().report(done.error());
}

void ForeignNotice::showState() {
    setVisible(m_session.program().isForeign());
    if (!m_session.program().isForeign())
        return;
    m_readAs->setText(tr("Read As"));
    m_readAs->setToolTip(tr("Choose the dialect of the program"));
    const Diagnostic& problem = m_session.program().current()->diagnostics().front(); // the only one
    showText(QStringLiteral("error"), sentence(problem) + u' ' + hint(problem));
}

void ForeignNotice::changeEvent(QEvent* event) {
    ViewNotice::changeEvent(event);
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        showState();
}

} // namespace proveout
