// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/tool_notice.h"

#include <algorithm>
#include <vector>

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/icons.h"
#include "ui/session.h"
#include "ui/tool_actions.h"

namespace proveout {

namespace {

constexpr int kMargin = 12; // px
constexpr int kWidest = 560;
constexpr int kIcon = 20;

/// Whether any motion of the program has a cutter.
bool cutsAnything(const Session& session) {
    const ToolChoice choice = toolChoice(session);
    const auto runs = session.program()->toolRuns();
    return std::ranges::any_of(runs, [&](const Program::ToolRun& run) {
        return session.setup().tools.find(choice.tool(run.tool)) != nullptr;
    });
}

} // namespace

ToolNotice::ToolNotice(Session& session, QWidget* parent)
    : QFrame(parent), m_session(session), m_icon(new QLabel(this)), m_text(new QLabel(this)),
      m_define(new QPushButton(this)), m_mend(new QPushButton(this)), m_close(new QToolButton(this)) {
    setObjectName(QStringLiteral("toolNotice"));
    m_text->setObjectName(QStringLiteral("toolNoticeText"));
    m_define->setObjectName(QStringLiteral("toolNoticeDefine"));
    m_mend->setObjectName(QStringLiteral("toolNoticeMend"));
    m_close->setObjectName(QStringLiteral("toolNoticeClose"));
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    m_text->setWordWrap(true);
    m_close->setAutoRaise(true);
    m_close->setIcon(style()->standardIcon(QStyle::SP_TitleBarCloseButton));
    auto* sentence = new QHBoxLayout;
    sentence->addWidget(m_icon, 0, Qt::AlignTop);
    sentence->addWidget(m_text, 1);
    sentence->addWidget(m_close, 0, Qt::AlignTop);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(m_define);
    buttons->addWidget(m_mend);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(sentence);
    layout->addLayout(buttons);
    parent->installEventFilter(this);
    connect(m_define, &QPushButton::clicked, this, [this] { emit m_session.toolRequested(m_tool); });
    connect(m_mend, &QPushButton::clicked, this,
            [this] { m_missing ? assumeMissingTools(m_session) : confirmTools(m_session); });
    connect(m_close, &QToolButton::clicked, this, [this] {
        m_dismissed = true;
        showState();
    });
    connect(&session, &Session::textReplaced, this, [this] { m_dismissed = false; });
    connect(&session, &Session::programChanged, this, &ToolNotice::showState);
    connect(&session, &Session::setupChanged, this, &ToolNotice::showState);
    showState();
}

void ToolNotice::showState() {
    const std::vector<int> missing = missingTools(m_session);
    m_missing = !missing.empty();
    const bool unconfirmed = !m_dismissed && !toolChoice(m_session).unconfirmed().empty();
    if (m_missing)
        showMissing(missing);
    else if (unconfirmed)
        showUnconfirmed();
    m_close->setVisible(!m_missing);
    m_close->setToolTip(tr("Hide this notice"));
    m_close->setAccessibleName(tr("Hide this notice"));
    m_icon->setPixmap(icon(m_missing ? QStringLiteral("error") : QStringLiteral("warning")).pixmap(kIcon));
    setVisible(m_missing || unconfirmed);
    place();
}

void ToolNotice::showMissing(const std::vector<int>& missing) {
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
    m_text->setText(cutsAnything(m_session) ? sentence : tr("Nothing is cut.") + u' ' + sentence);
    m_define->setText(tr("Define T%1 …").arg(m_tool));
    m_define->setToolTip(tr("Add T%1 to the tool table and enter its sizes").arg(m_tool));
    m_mend->setText(tr("Assume ⌀ 10 mm"));
    m_mend->setToolTip(tr("Add the missing tools as flat end mills of 10 mm, marked as assumed"));
}

void ToolNotice::showUnconfirmed() {
    const std::vector<UnconfirmedTool> tools = toolChoice(m_session).unconfirmed();
    const UnconfirmedTool& first = tools.front();
    m_tool = first.number;
    std::vector<int> numbers;
    for (const UnconfirmedTool& tool : tools)
        numbers.push_back(tool.number);
    const QString cutter = cutterText(*m_session.setup().tools.find(m_tool), locale());
    QString sentence;
    if (tools.size() > 1)
        sentence = tr("The sizes of %1 are not confirmed.").arg(toolList(numbers));
    else if (first.origin.source == ToolSource::comment)
        sentence = tr("T%1 is read from the comment in line %2: %3.")
                       .arg(QString::number(m_tool), locale().toString(first.origin.line), cutter);
    else
        sentence = tr("The sizes of T%1 are assumed: %2.").arg(QString::number(m_tool), cutter);
    m_text->setText(sentence + u' ' + tr("Results are unverified until you confirm the sizes."));
    m_define->setText(tr("Check …"));
    m_define->setToolTip(tr("Show T%1 in the tool table").arg(m_tool));
    m_mend->setText(tools.size() > 1 ? tr("Confirm All") : tr("Confirm"));
    m_mend->setToolTip(tr("The sizes in the tool table are right"));
}

void ToolNotice::place() {
    const int width = std::min(kWidest, parentWidget()->width() - 2 * kMargin);
    const int height = layout()->hasHeightForWidth() ? layout()->heightForWidth(width) : sizeHint().height();
    setGeometry((parentWidget()->width() - width) / 2, parentWidget()->height() - height - kMargin, width,
                height);
}

bool ToolNotice::eventFilter(QObject* watched, QEvent* event) {
    if (watched == parentWidget() && event->type() == QEvent::Resize)
        place();
    return QFrame::eventFilter(watched, event);
}

void ToolNotice::changeEvent(QEvent* event) {
    QFrame::changeEvent(event);
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        showState();
}

} // namespace proveout
