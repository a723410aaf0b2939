// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/tool_notice.h"

#include <algorithm>
#include <vector>

#include <QEvent>
#include <QHBoxLayout>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>

#include "ui/readout/tool_actions.h"
#include "ui/session/session.h"

namespace proveout {

namespace {

/// Whether any motion of the program has a defined cutter.
bool cutsAnything(const Session& session) {
    const ToolChoice choice = toolChoice(session);
    const auto runs = session.program().current()->toolRuns();
    return std::ranges::any_of(runs, [&](const Program::ToolRun& run) {
        return session.job().setup().tools.find(choice.tool(run.tool)) != nullptr;
    });
}

} // namespace

ToolNotice::ToolNotice(Session& session, QWidget* parent)
    : ViewNotice(parent), m_session(session), m_define(new QPushButton(this)), m_mend(new QPushButton(this)),
      m_close(new QToolButton(this)) {
    setObjectName(QStringLiteral("toolNotice"));
    m_define->setObjectName(QStringLiteral("toolNoticeDefine"));
    m_mend->setObjectName(QStringLiteral("toolNoticeMend"));
    m_close->setObjectName(QStringLiteral("toolNoticeClose"));
    m_close->setAutoRaise(true);
    m_close->setIcon(style()->standardIcon(QStyle::SP_TitleBarCloseButton));
    sentenceRow().addWidget(m_close, 0, Qt::AlignTop);
    buttonRow().addWidget(m_define);
    buttonRow().addWidget(m_mend);
    connect(m_define, &QPushButton::clicked, this,
            [this] { emit m_session.navigation().toolRequested(m_tool); });
    connect(m_mend, &QPushButton::clicked, this,
            [this] { m_missing ? assumeMissingTools(m_session) : confirmTools(m_session); });
    connect(m_close, &QToolButton::clicked, this, [this] {
        m_dismissed = true;
        showState();
    });
    connect(&session.document(), &DocumentHub::textReplaced, this, [this] { m_dismissed = false; });
    connect(&session.program(), &ProgramHub::changed, this, &ToolNotice::showState);
    connect(&session.job(), &JobHub::setupChanged, this, &ToolNotice::showState);
    showState();
}

void ToolNotice::showState() {
    const std::vector<int> missing = missingTools(m_session);
    m_missing = !missing.empty();
    const bool unconfirmed = !m_dismissed && !toolChoice(m_session).unconfirmed().empty();
    m_close->setVisible(!m_missing);
    m_close->setToolTip(tr("Hide this notice"));
    m_close->setAccessibleName(tr("Hide this notice"));
    setVisible(m_missing || unconfirmed);
    if (m_missing)
        showText(QStringLiteral("error"), missingText(missing));
    else if (unconfirmed)
        showText(QStringLiteral("warning"), unconfirmedText());
}

QString ToolNotice::missingText(const std::vector<int>& missing) {
    m_tool = missing.front();
    const ToolChoice choice = toolChoice(m_session);
    const MissingTool& first = choice.missing().front();
    const bool before = first.number == 0 && !first.called;
    QString sentence;
    if (before && !choice.callsTool())
        sentence = tr("The program calls no tool; its moves are not simulated.");
    else if (before)
        sentence = tr("The program cuts before it calls a tool; those moves are not simulated.");
    else if (missing.size() == 1)
        sentence = tr("T%1 is not in the tool table; its moves are not simulated.").arg(m_tool);
    else
        sentence = tr("%1 are not in the tool table; their moves are not simulated.").arg(toolList(missing));
    m_define->setText(tr("Define T%1…").arg(m_tool));
    m_define->setToolTip(tr("Add T%1 to the tool table and enter its sizes").arg(m_tool));
    m_mend->setText(tr("Assume ⌀ 10 mm"));
    m_mend->setToolTip(tr("Add the missing tools as 10 mm flat end mills, marked as assumed"));
    return cutsAnything(m_session) ? sentence : tr("Nothing is cut.") + u' ' + sentence;
}

QString ToolNotice::unconfirmedText() {
    const std::vector<UnconfirmedTool> tools = toolChoice(m_session).unconfirmed();
    const UnconfirmedTool& first = tools.front();
    m_tool = first.number;
    std::vector<int> numbers;
    numbers.reserve(tools.size());
    for (const UnconfirmedTool& tool : tools)
        numbers.push_back(tool.number);
    const QString cutter = cutterText(*m_session.job().setup().tools.find(m_tool), locale());
    QString sentence;
    if (tools.size() > 1)
        sentence = tr("The sizes of %1 are not confirmed.").arg(toolList(numbers));
    else if (first.origin.source == ToolSource::comment)
        sentence = tr("T%1 was read from the comment in line %2: %3.")
                       .arg(QString::number(m_tool), locale().toString(first.origin.line), cutter);
    else
        sentence = tr("The sizes of T%1 are assumed: %2.").arg(QString::number(m_tool), cutter);
    m_define->setText(tr("Check…"));
    m_define->setToolTip(tr("Show T%1 in the tool table").arg(m_tool));
    m_mend->setText(tools.size() > 1 ? tr("Confirm All") : tr("Confirm"));
    m_mend->setToolTip(tr("Confirm the sizes in the tool table"));
    return sentence + u' ' + tr("Results are unverified until you confirm the sizes.");
}

void ToolNotice::changeEvent(QEvent* event) {
    ViewNotice::changeEvent(event);
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        showState();
}

} // namespace proveout
