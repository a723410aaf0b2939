// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/timeline/timeline_panel.h"

#include <algorithm>
#include <cmath>

#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QToolTip>

#include "ui/look/choice_box.h"
#include "ui/look/theme.h"
#include "ui/program/program_index.h"
#include "ui/readout/cycle_time_text.h"
#include "ui/readout/problem_list.h"
#include "ui/readout/tool_actions.h"
#include "ui/timeline/activity_text.h"
#include "ui/timeline/timeline_scale.h"

namespace proveout {

namespace {

constexpr int kPaperMode = kSpeedCount; // the item after the speeds
constexpr int kPaceCount = 3;           // number of PlayBy values
constexpr int kIconSize = 20;
constexpr double kLags = 0.95; // share of the requested speed
constexpr int kMostDecimals = 3;
constexpr double kWidestLag = 1000; // factor of the unit speed, for the widest text

/// Two significant digits without an exponent, because a speed must be readable at a glance.
QString roundedText(const QLocale& locale, double value) {
    if (!(value > 0) || !std::isfinite(value))
        return locale.toString(value);
    const int exponent = static_cast<int>(std::floor(std::log10(value)));
    const double step = std::pow(10.0, exponent - 1);
    return locale.toString(std::round(value / step) * step, 'f', std::clamp(1 - exponent, 0, kMostDecimals));
}

} // namespace

TimelinePanel::TimelinePanel(Session& session, const PlaybackCommands& commands, QWidget* parent)
    : QWidget(parent), m_session(session), m_activity(session), m_scale(new TimelineScale(this)),
      m_position(new QLabel(this)), m_time(new QLabel(this)), m_lag(new QLabel(this)),
      m_by(new ChoiceBox(this)), m_speedLabel(new QLabel(this)), m_speed(new ChoiceBox(this)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 4);
    layout->setSpacing(2);
    addTransport(*layout, commands);
    layout->addWidget(m_scale, 1);
    addReadings(*layout);
    layout->addSpacing(8);
    layout->addWidget(m_by);
    layout->addSpacing(4);
    layout->addWidget(m_speedLabel);
    layout->addSpacing(4);
    layout->addWidget(m_speed);
    m_position->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_time->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_speedLabel->setBuddy(m_speed);
    for (int pace = 0; pace < kPaceCount; ++pace)
        m_by->addItem(QString());
    for (int speed = 0; speed <= kPaperMode; ++speed)
        m_speed->addItem(QString());
    m_speed->setMaxVisibleItems(m_speed->count());
    m_by->setObjectName(QStringLiteral("play-by"));
    m_speed->setObjectName(QStringLiteral("play-speed"));
    m_lag->setObjectName(QStringLiteral("playback-lag"));
    m_lag->hide();
    setFocusProxy(m_scale);
    m_scale->setActivity(m_activity.log());
    for (QAction* action : commands.actions().all())
        addAction(action);

    connect(m_scale, &TimelineScale::scrubbed, &session.playback(), &PlaybackHub::seek);
    connect(m_scale, &TimelineScale::stepped, &session.playback(), &PlaybackHub::step);
    connect(m_scale, &TimelineScale::tipWanted, this, &TimelinePanel::showTip);
    connect(m_speed, &QComboBox::activated, this, &TimelinePanel::chooseSpeed);
    connect(m_by, &QComboBox::activated, this,
            [&session](int index) { session.playback().setPlayBy(static_cast<PlayBy>(index)); });
    connect(&session.playback(), &PlaybackHub::changed, this, &TimelinePanel::showSpeed);
    connect(&session.breakpoints(), &BreakpointList::changed, this, &TimelinePanel::showProgram);
    connect(&session.program(), &ProgramHub::timesChanged, this, &TimelinePanel::showTimes);
    connect(&session.job(), &JobHub::setupChanged, this,
            &TimelinePanel::showTimes); // because the text names the tools
    connect(&session.program(), &ProgramHub::changed, this, &TimelinePanel::showProgram);
    connect(&session.problems(), &ProblemsHub::changed, this, &TimelinePanel::showProgram);
    connect(&session.check(), &CheckHub::changed, this, [this] {
        if (m_session.check().report())
            showProgram();
    });
    connect(&session.playback(), &PlaybackHub::tick, this, &TimelinePanel::showFrame);
    retranslate();
    showProgram();
}

void TimelinePanel::addTransport(QHBoxLayout& layout, const PlaybackCommands& commands) {
    for (const char* id : {"to-start", "step-back", "play", "step-forward", "to-end"}) {
        auto* button = new QToolButton(this);
        button->setDefaultAction(commands.actions().find(id));
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::TabFocus); // a click must not take the arrow keys from the focused widget
        button->setIconSize({kIconSize, kIconSize});
        button->setAutoRepeat(button->defaultAction()->shortcutContext() != Qt::WindowShortcut);
        layout.addWidget(button);
    }
    layout.addSpacing(6);
}

/// The actual speed is shown only at times, so it is in the lower row, where its space is always reserved.
void TimelinePanel::addReadings(QHBoxLayout& layout) {
    auto* readings = new QGridLayout;
    readings->setHorizontalSpacing(8);
    readings->setVerticalSpacing(0);
    readings->addWidget(m_position, 0, 0);
    readings->addWidget(m_time, 0, 1);
    readings->addWidget(m_lag, 1, 0, 1, 2, Qt::AlignRight);
    QSizePolicy policy = m_lag->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    m_lag->setSizePolicy(policy);
    layout.addLayout(readings);
}

void TimelinePanel::retranslate() {
    m_scale->setAccessibleName(tr("Timeline"));
    m_scale->setStatusTip(tr("Drag to go to any block; wheel or arrow keys: one block, with Shift: more"));
    m_speedLabel->setText(tr("Speed"));
    m_speed->setAccessibleName(tr("Speed"));
    m_by->setAccessibleName(tr("Play by"));
    m_by->setToolTip(tr("Pace of playback: by block, by path length or by machine time"));
    m_position->setToolTip(tr("Motion blocks executed / total"));
    m_lag->setToolTip(tr(
        "Cutting takes longer than this speed allows: playback is slower, but the stock is always correct"));
    m_lag->setMinimumWidth(fontMetrics().horizontalAdvance(lagText(kWidestLag)) + 8);
    namePaces();
    nameSpeeds();
    showSpeed();
    showTimes();
}

/// Updates the items in place, as for the speeds, because the list may be open when its own selection calls
/// this.
void TimelinePanel::namePaces() {
    const QStringList names{tr("Blocks"), tr("Path length"), tr("Machine time")}; // same order as PlayBy
    for (int index = 0; index < m_by->count(); ++index)
        m_by->setItemText(index, names[index]);
}

QString TimelinePanel::speedName(double speed, PlayBy by) const {
    if (std::isinf(speed))
        return tr("As fast as possible");
    const double factor = speed / kUnitBlocksPerSecond;
    const QString times = locale().toString(factor);
    const QString units = locale().toString(factor * unitSpeed(by));
    if (by == PlayBy::blocks)
        return tr("%1× (%2 blocks/s)").arg(times, units);
    if (by == PlayBy::length)
        return tr("%1× (%2 mm/s)").arg(times, units);
    return tr("%1× machine").arg(times);
}

void TimelinePanel::nameSpeeds() {
    const PlayBy by = m_session.playback().state().by;
    for (int index = 0; index < kSpeedCount; ++index)
        m_speed->setItemText(index, speedName(speeds()[static_cast<std::size_t>(index)], by));
    m_speed->setItemText(kPaperMode, tr("Every block (paper mode)"));
    m_speed->setItemData(kPaperMode, tr("Each block is drawn before the next one is cut"), Qt::ToolTipRole);
    m_speed->setToolTip(
        by == PlayBy::blocks   ? tr("Playback speed; 1× is %1 blocks per second").arg(unitSpeed(by))
        : by == PlayBy::length ? tr("Playback speed; 1× is %1 mm of path per second").arg(unitSpeed(by))
                               : tr("Playback speed; 1× is the speed of the machine"));
    m_namedFor = by;
}

void TimelinePanel::showSpeed() {
    const Playback& playback = m_session.playback().state();
    if (playback.by != m_namedFor)
        nameSpeeds();
    m_by->setCurrentIndex(static_cast<int>(playback.by));
    const auto& all = speeds();
    const double factor = playback.unitsPerSecond / unitSpeed(playback.by);
    const auto nearest = std::lower_bound(all.begin(), all.end(), factor * kUnitBlocksPerSecond * (1 - 1e-9));
    const auto index = static_cast<int>(std::min<std::ptrdiff_t>(nearest - all.begin(), kSpeedCount - 1));
    const QSignalBlocker quiet(m_speed);
    m_speed->setCurrentIndex(playback.everyBlock ? kPaperMode : index);
}

void TimelinePanel::chooseSpeed(int index) {
    const auto speed = static_cast<std::size_t>(std::clamp(index, 0, kSpeedCount - 1));
    const double factor = speeds()[speed] / kUnitBlocksPerSecond;
    m_session.playback().setSpeed(factor * unitSpeed(m_session.playback().state().by), index == kPaperMode);
}

void TimelinePanel::showProgram() {
    m_scale->setBlockCount(m_session.program().blockCount());
    std::vector<TimelineMark> marks;
    if (const auto& program = m_session.program().current()) {
        for (const ToolChangeMark& change : toolChangeMarks(*program))
            marks.push_back({change.block, TimelineMark::Kind::toolChange, Severity::note});
        for (const CheckFinding& problem : problemsInText(m_session)) {
            const auto line = static_cast<std::uint32_t>(problem.diagnostic.where.line);
            marks.push_back({problem.block > 0 ? problem.block : program->blocksAfterLine(line),
                             TimelineMark::Kind::problem, problem.diagnostic.severity});
        }
        for (const Breakpoint& breakpoint : m_session.breakpoints().all()) {
            if (breakpoint.enabled && breakpoint.kind == BreakpointKind::line)
                marks.push_back({program->blocksBeforeLine(breakpoint.line), TimelineMark::Kind::breakpoint,
                                 Severity::note});
        }
    }
    m_scale->setMarks(std::move(marks));
    showFrame(m_session.simulation().frame());
}

void TimelinePanel::showFrame(const FramePtr& frame) {
    const std::size_t block = frame ? frame->block : 0;
    m_scale->setBlock(block);
    showTime(block);
    showLag(frame);
    showActivity(frame);
    const QString last = locale().toString(static_cast<qulonglong>(m_session.program().blockCount()));
    const QString text =
        QStringLiteral("%1 / %2").arg(locale().toString(static_cast<qulonglong>(block)), last);
    if (text == m_position->text())
        return;
    // Wide enough for the last block number, so that the layout does not change while the number grows.
    m_position->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("%1 / %1").arg(last)) + 8);
    m_position->setText(text);
}

/// Cycle time up to the current block, and of the whole program.
void TimelinePanel::showTime(std::size_t block) {
    const auto& times = m_session.program().times();
    const bool known = times && block < times->secondsAfter.size();
    const QString text = known ? QStringLiteral("%1 / %2").arg(clockText(times->secondsAfter[block]),
                                                               clockText(times->parts.total()))
                               : QString();
    if (text != m_time->text())
        m_time->setText(text);
}

void TimelinePanel::showTimes() {
    const auto& times = m_session.program().times();
    m_time->setVisible(times != nullptr && times->parts.total() > 0);
    if (!times)
        return;
    const QString last = clockText(times->parts.total());
    m_time->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("%1 / %1").arg(last)) + 8);
    m_timeTip =
        timeTip(*times, !m_session.job().machine(), toolChoice(m_session), m_session.job().setup().tools);
    reportShares();
    showTime(m_session.simulation().block());
}

void TimelinePanel::showActivity(const FramePtr& frame) {
    if (!m_activity.follow(frame.get()))
        return;
    m_scale->update();
    reportShares();
}

/// The shares of the machine time, of the program and of what has been cut until now.
void TimelinePanel::reportShares() {
    const QString shares = activitySummary(m_activity.log());
    m_time->setToolTip(shares.isEmpty() ? m_timeTip : m_timeTip + u'\n' + shares);
}

QString TimelinePanel::lagText(double speed) const {
    return tr("Actual speed %1×").arg(roundedText(locale(), speed));
}

void TimelinePanel::showLag(const FramePtr& frame) {
    const bool lags = frame && frame->playing && frame->keptSpeed < kLags;
    if (lags) {
        const double speed = frame->keptSpeed * m_session.playback().state().unitsPerSecond /
                             unitSpeed(m_session.playback().state().by);
        m_lag->setText(lagText(speed));
        m_lag->setStyleSheet(QStringLiteral("color: %1").arg(meaningColors(palette()).warning.name()));
    }
    m_lag->setVisible(lags);
}

void TimelinePanel::showTip(std::size_t block, QPoint globalPlace) {
    const auto& program = m_session.program().current();
    if (!program || program->blockCount() == 0)
        return;
    const std::size_t executed = std::max<std::size_t>(block, 1) - 1;
    const Motion motion = program->motion(program->blockMotions(executed).first);
    QStringList tip{tr("Block %1 · line %2 · %3")
                        .arg(locale().toString(static_cast<qulonglong>(block)))
                        .arg(program->blockLine(executed))
                        .arg(toolText(motion.tool, toolChoice(m_session), m_session.job().setup().tools))
                        .toHtmlEscaped()};
    const auto line = static_cast<int>(program->blockLine(executed));
    if (std::ranges::any_of(problemsInText(m_session), [line](const CheckFinding& problem) {
            return problem.diagnostic.where.line == line;
        }))
        tip << tr("There is a problem on this line.").toHtmlEscaped();
    const auto stretch = m_scale->stretchAt(m_scale->mapFromGlobal(globalPlace).x());
    tip << activityLegend(m_activity.log(), stretch, ActivityStrip::colors(palette()));
    QToolTip::showText(
        globalPlace,
        QStringLiteral("<p style=\"white-space:pre\">%1</p>").arg(tip.join(QStringLiteral("<br>"))), m_scale);
}

void TimelinePanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace proveout
