// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/timeline/timeline_panel.h"

#include <algorithm>
#include <cmath>

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QToolTip>

#include "ui/choice_box.h"
#include "ui/program_index.h"
#include "ui/timeline/timeline_scale.h"

namespace proveout {

namespace {

constexpr int kPaperMode = kSpeedCount; // the entry behind the speeds
constexpr int kIconSize = 20;

} // namespace

TimelinePanel::TimelinePanel(Session& session, const PlaybackCommands& commands, QWidget* parent)
    : QWidget(parent), m_session(session), m_scale(new TimelineScale(this)), m_position(new QLabel(this)),
      m_speedLabel(new QLabel(this)), m_speed(new ChoiceBox(this)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 4);
    layout->setSpacing(2);
    addTransport(*layout, commands);
    layout->addWidget(m_scale, 1);
    layout->addWidget(m_position);
    layout->addSpacing(8);
    layout->addWidget(m_speedLabel);
    layout->addSpacing(4);
    layout->addWidget(m_speed);
    m_position->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_speedLabel->setBuddy(m_speed);
    setFocusProxy(m_scale);
    for (QAction* action : commands.actions().all())
        addAction(action);

    connect(m_scale, &TimelineScale::scrubbed, &session, &Session::seek);
    connect(m_scale, &TimelineScale::stepped, &session, &Session::step);
    connect(m_scale, &TimelineScale::tipWanted, this, &TimelinePanel::showTip);
    connect(m_speed, &QComboBox::activated, this, &TimelinePanel::chooseSpeed);
    connect(&session, &Session::playbackChanged, this, &TimelinePanel::showSpeed);
    connect(&session, &Session::programChanged, this, &TimelinePanel::showProgram);
    connect(&session, &Session::problemsChanged, this, &TimelinePanel::showProgram);
    connect(&session, &Session::tick, this, &TimelinePanel::showFrame);
    retranslate();
    showProgram();
}

void TimelinePanel::addTransport(QHBoxLayout& layout, const PlaybackCommands& commands) {
    for (const char* id : {"to-start", "step-back", "play", "step-forward", "to-end"}) {
        auto* button = new QToolButton(this);
        button->setDefaultAction(commands.actions().find(id));
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus); // a click leaves the arrow keys where they were
        button->setIconSize({kIconSize, kIconSize});
        button->setAutoRepeat(button->defaultAction()->shortcutContext() != Qt::WindowShortcut);
        layout.addWidget(button);
    }
    layout.addSpacing(6);
}

void TimelinePanel::retranslate() {
    m_scale->setAccessibleName(tr("Timeline"));
    m_scale->setStatusTip(
        tr("Drag to see the stock after any block; wheel or arrow keys: one block, with Shift: more"));
    m_speedLabel->setText(tr("Speed"));
    m_speed->setToolTip(tr("Playing speed; 1× is %1 blocks a second").arg(kUnitBlocksPerSecond));
    m_speed->setAccessibleName(tr("Speed"));
    m_position->setToolTip(tr("Blocks executed / blocks that move"));
    fillSpeeds();
    showSpeed();
}

void TimelinePanel::fillSpeeds() {
    const QSignalBlocker quiet(m_speed);
    m_speed->clear();
    for (const double speed : speeds()) {
        m_speed->addItem(std::isinf(speed) ? tr("As fast as possible")
                                           : tr("%1× (%2 blocks/s)")
                                                 .arg(locale().toString(speed / kUnitBlocksPerSecond),
                                                      locale().toString(speed)));
    }
    m_speed->addItem(tr("Every block (paper mode)"));
    m_speed->setItemData(kPaperMode, tr("Each block is drawn before the next one is cut"), Qt::ToolTipRole);
    m_speed->setMaxVisibleItems(m_speed->count());
}

void TimelinePanel::showSpeed() {
    const Playback& playback = m_session.playback();
    const auto& all = speeds();
    const auto nearest = std::lower_bound(all.begin(), all.end(), playback.blocksPerSecond * (1 - 1e-9));
    const auto index = static_cast<int>(std::min<std::ptrdiff_t>(nearest - all.begin(), kSpeedCount - 1));
    const QSignalBlocker quiet(m_speed);
    m_speed->setCurrentIndex(playback.everyBlock ? kPaperMode : index);
}

void TimelinePanel::chooseSpeed(int index) {
    const auto speed = static_cast<std::size_t>(std::clamp(index, 0, kSpeedCount - 1));
    m_session.setSpeed(speeds()[speed], index == kPaperMode);
}

void TimelinePanel::showProgram() {
    m_scale->setBlockCount(m_session.blockCount());
    std::vector<TimelineMark> marks;
    if (const auto& program = m_session.program()) {
        for (const ToolChangeMark& change : toolChangeMarks(*program))
            marks.push_back({change.block, true, Severity::note});
        for (const Diagnostic& problem : m_session.problems()) {
            if (Session::isInText(problem))
                marks.push_back({program->blocksAfterLine(static_cast<std::uint32_t>(problem.where.line)),
                                 false, problem.severity});
        }
    }
    m_scale->setMarks(std::move(marks));
    showFrame(m_session.frame());
}

void TimelinePanel::showFrame(const FramePtr& frame) {
    const std::size_t block = frame ? frame->block : 0;
    m_scale->setBlock(block);
    const QString last = locale().toString(static_cast<qulonglong>(m_session.blockCount()));
    const QString text =
        QStringLiteral("%1 / %2").arg(locale().toString(static_cast<qulonglong>(block)), last);
    if (text == m_position->text())
        return;
    // Wide enough for the last block, so that nothing moves while the number grows.
    m_position->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("%1 / %1").arg(last)) + 8);
    m_position->setText(text);
}

void TimelinePanel::showTip(std::size_t block, QPoint globalPlace) {
    const auto& program = m_session.program();
    if (!program || program->blockCount() == 0)
        return;
    const std::size_t executed = std::max<std::size_t>(block, 1) - 1;
    const Motion motion = program->motion(program->blockMotions(executed).first);
    QString tip = tr("Block %1 · line %2 · tool T%3")
                      .arg(locale().toString(static_cast<qulonglong>(block)))
                      .arg(program->blockLine(executed))
                      .arg(motion.tool);
    for (const Diagnostic& problem : m_session.problems()) {
        if (Session::isInText(problem) &&
            problem.where.line == static_cast<int>(program->blockLine(executed)))
            tip += u'\n' + tr("There is a problem on this line.");
    }
    QToolTip::showText(globalPlace, tip, m_scale);
}

void TimelinePanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace proveout
