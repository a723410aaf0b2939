// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/status_line.h"

#include <algorithm>
#include <utility>

#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QStatusBar>
#include <QToolButton>

#include "core/nc/program/active_offset.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/elided_label.h"
#include "ui/readout/export_text.h"
#include "ui/readout/probe_text.h"
#include "ui/readout/surface_probe.h"
#include "ui/readout/tool_actions.h"

namespace proveout {

namespace {

constexpr int kProgressWidth = 140; // px, unless its text is wider
constexpr int kProgressMargin = 24;
constexpr int kProgressSteps = 100;
constexpr int kAnswerTime = 15'000;        // ms
constexpr int kProblemTime = 8'000;        // ms
constexpr int kMargin = 6;                 // px
constexpr double kFarPosition = -8888.888; // mm, as wide as any coordinate within it
const QString kWideWord = QStringLiteral("88888");
const QString kWideTool = QStringLiteral("888");

QString millimetres(const QLocale& locale, double value) {
    return locale.toString(value, 'f', 3);
}

/// Formatted as in a program, without group separators, because F and S are words.
QString wordValue(QLocale locale, double value) {
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(value, 'g', 6);
}

/// "1:05", minutes and seconds.
QString minutesText(int seconds) {
    return QStringLiteral("%1:%2").arg(seconds / 60).arg(seconds % 60, 2, 10, QLatin1Char('0'));
}

/// The last motion that was executed in the frame.
Motion lastMotion(const Frame& frame) {
    return frame.program->motion(frame.program->blockMotions(frame.block - 1).last - 1);
}

} // namespace

StatusLine::StatusLine(Session& session, QStatusBar& bar)
    : QObject(&bar), m_session(session), m_bar(bar), m_place(new ElidedLabel(&bar)),
      m_progress(new QProgressBar(&bar)), m_cancel(new QToolButton(&bar)) {
    m_place->setObjectName(QStringLiteral("status-place"));
    m_place->setContentsMargins(kMargin, 0, kMargin, 0);
    bar.addWidget(m_place, 1);
    bar.addPermanentWidget(m_progress);
    bar.addPermanentWidget(m_cancel);
    for (QLabel*& field : m_fields) {
        field = new QLabel(&bar);
        bar.addPermanentWidget(field);
    }
    m_progress->setRange(0, kProgressSteps);
    m_progress->setFixedWidth(kProgressWidth);
    m_progress->setAlignment(Qt::AlignCenter);
    m_cancel->setAutoRaise(true);
    connect(m_cancel, &QToolButton::clicked, &session.work(), &WorkHub::cancel);
    connect(&session.playback(), &PlaybackHub::tick, this, &StatusLine::onTick);
    connect(&session.program(), &ProgramHub::changed, this, &StatusLine::fitFields);
    connect(&session.work(), &WorkHub::changed, &session.playback(), &PlaybackHub::requestTick);
    connect(&bar, &QStatusBar::messageChanged, &bar, [&bar] { bar.setToolTip({}); });
    connect(&session.exports(), &ExportHub::exported, this, [this](const ExportSummary& summary) {
        const QString text = exportText(summary, m_bar.locale());
        say(text, Until::edited);
        // a narrow window cuts the message off
        m_bar.setToolTip(text + QLatin1Char('\n') + exportDetails(summary, m_bar.locale()));
    });
    connect(&session.problems(), &ProblemsHub::changed, this, &StatusLine::forgetProblem);
    connect(&session.document(), &DocumentHub::textReplaced, this, [this] { forget(Until::edited); });
    connect(&session.program(), &ProgramHub::changed, this, [this] { forget(Until::edited); });
    connect(&session.job(), &JobHub::setupChanged, this, [this] { forget(Until::edited); });
    connect(&session.work(), &WorkHub::changed, this, [this] {
        if (m_session.exports().isRunning())
            forget(Until::edited);
    });
    connect(&session.playback(), &PlaybackHub::changed, this, [this] {
        if (m_session.playback().state().playing)
            forget(Until::moved);
    });
    connect(&session.playback(), &PlaybackHub::stoppedAt, this, &StatusLine::reportStop);
    connect(&session.navigation(), &NavigationHub::placeFound, this, &StatusLine::reportPlace);
    retranslate();
}

/// Shows why the run stopped, until it continues or another message is shown.
void StatusLine::reportStop(const BreakpointHit& hit) {
    const QString reason = coreText(rowOf(hit.breakpoint.kind).reason, {valueText(hit.breakpoint)});
    say(reason, Until::moved, m_session.simulation().block());
}

void StatusLine::say(const QString& text, Until until, std::size_t block, int milliseconds) {
    m_said = text;
    m_until = until;
    m_saidOf = block;
    m_arrived = false;
    m_bar.showMessage(text, milliseconds);
}

/// An edit also clears the messages that a move clears.
void StatusLine::forget(Until event) {
    if (m_said.isEmpty() || (event == Until::moved && m_until == Until::edited))
        return;
    if (m_bar.currentMessage() == m_said)
        m_bar.clearMessage();
    m_said.clear();
}

void StatusLine::reportPlace(const PlaceAnswer& answer) {
    const QString block = m_bar.locale().toString(static_cast<qulonglong>(answer.block));
    const QString text = [&]() -> QString {
        switch (answer.kind) {
        case PlaceAnswer::Kind::noStock:
            return tr("There is no stock at this point.");
        case PlaceAnswer::Kind::neverCut:
            return tr("Raw stock: not cut up to block %1.").arg(block);
        case PlaceAnswer::Kind::outdated:
            return tr("The program or setup has changed. Try again in a moment.");
        case PlaceAnswer::Kind::cut:
            return tr("Cut by block %1: line %2, tool %3.")
                .arg(block, QString::number(answer.line), proveout::toolText(answer));
        }
        return {};
    }();
    say(text, Until::moved, answer.block, kAnswerTime);
    m_bar.setToolTip(text); // a narrow window cuts the message off
}

void StatusLine::reportProblem() {
    if (m_session.problems().all().empty())
        return;
    m_problem = sentence(m_session.problems().all().front());
    m_bar.showMessage(m_problem, kProblemTime);
}

void StatusLine::forgetProblem() {
    if (m_problem.isEmpty())
        return;
    const bool stays = std::ranges::any_of(m_session.problems().all(), [this](const Diagnostic& problem) {
        return sentence(problem) == m_problem;
    });
    if (stays)
        return;
    if (m_bar.currentMessage() == m_problem)
        m_bar.clearMessage();
    m_problem.clear();
}

/// A message may be about a block whose frame has not arrived yet.
void StatusLine::forgetWhatIsBehind(const Frame& frame) {
    if (frame.block == m_saidOf)
        m_arrived = true;
    else if (m_arrived)
        forget(Until::moved);
}

void StatusLine::follow(const SurfaceProbe& pointer) {
    m_pointer = &pointer;
    connect(&pointer, &SurfaceProbe::moved, this, &StatusLine::showPlace);
}

void StatusLine::showPlace() {
    if (m_pointer == nullptr)
        return;
    const QString position = positionText(*m_pointer, m_bar.locale());
    const QString cut = cutText(*m_pointer);
    m_place->setText(cut.isEmpty() ? position : position + QStringLiteral("   ·   ") + cut);
}

void StatusLine::retranslate() {
    m_cancel->setText(tr("Cancel"));
    m_cancel->setToolTip(tr("Cancel this task"));
    const std::array<QString, kFieldCount> tips{tr("Tool tip X in the active work offset, mm"),
                                                tr("Tool tip Y in the active work offset, mm"),
                                                tr("Tool tip Z in the active work offset, mm"),
                                                tr("Feed rate, mm/min"),
                                                tr("Spindle speed, rpm"),
                                                tr("Tool in the spindle"),
                                                tr("Motion blocks executed / total"),
                                                tr("Triangles shown")};
    for (std::size_t i = 0; i < m_fields.size(); ++i)
        m_fields[i]->setToolTip(tips[i]);
    fitFields();
    showFrame(m_session.simulation().frame());
    showWork();
}

void StatusLine::fitFields() {
    const QLocale locale = m_bar.locale();
    const auto fit = [this](Field field, const QStringList& texts) {
        int widest = 0;
        for (const QString& text : texts)
            widest = std::max(widest, m_bar.fontMetrics().horizontalAdvance(text));
        m_fields[field]->setFixedWidth(widest + kMargin);
    };
    const QString far = millimetres(locale, kFarPosition);
    fit(kX, {QStringLiteral("X ") + far});
    fit(kY, {QStringLiteral("Y ") + far});
    fit(kZ, {QStringLiteral("Z ") + far});
    fit(kFeed, {QStringLiteral("F ") + kWideWord, tr("F rapid")});
    fit(kSpindle, {QStringLiteral("S ") + kWideWord});
    const QString tool = QStringLiteral("T ") + kWideTool;
    fit(kTool, {m_toolAssumed ? assumedText(tool) : tool});
    const QString last = locale.toString(static_cast<qulonglong>(m_session.program().blockCount()));
    fit(kBlock, {tr("Block %1 / %2").arg(last, last)});
    fit(kFaces, {tr("Triangles %1").arg(locale.toString(static_cast<qulonglong>(m_facesFull)))});
}

void StatusLine::onTick(const FramePtr& frame) {
    showWork();
    if (frame)
        forgetWhatIsBehind(*frame);
    showPlace();
    const bool otherFaces =
        frame && std::exchange(m_facesFull, frame->surface.facesFull) != frame->surface.facesFull;
    const bool toolAssumed = frame && frame->toolAssumed;
    if (std::exchange(m_toolAssumed, toolAssumed) != toolAssumed || otherFaces)
        fitFields();
    // Updated at every tick like all other panels, because two counts of the same moment must be equal.
    showFrame(frame);
}

void StatusLine::set(Field field, const QString& text) {
    QLabel* label = m_fields[static_cast<std::size_t>(field)];
    if (label->text() != text)
        label->setText(text);
}

void StatusLine::showFrame(const FramePtr& frame) {
    const QLocale locale = m_bar.locale();
    const bool executed = frame && frame->block > 0;
    const auto number = [&](std::size_t value) { return locale.toString(static_cast<qulonglong>(value)); };
    const auto axis = [&](const char* name, double value) {
        return QLatin1String(name) +
               (executed && frame->cutterKnown ? millimetres(locale, value) : QStringLiteral("–"));
    };
    const ActiveOffset offset =
        frame && frame->program ? activeOffset(*frame->program, frame->block) : ActiveOffset();
    const Vec3 position = frame ? frame->cutterPosition - offset.zero : Vec3(0);
    set(kX, axis("X ", position.x));
    set(kY, axis("Y ", position.y));
    set(kZ, axis("Z ", position.z));
    const Motion motion = executed ? lastMotion(*frame) : Motion();
    const QString none = QStringLiteral("–");
    set(kFeed, executed && motion.kind == MotionKind::rapid
                   ? tr("F rapid")
                   : QStringLiteral("F ") + (executed ? wordValue(locale, motion.feedMmPerMin) : none));
    set(kSpindle, QStringLiteral("S ") + (executed ? wordValue(locale, motion.spindleRpm) : none));
    set(kTool, frame ? toolText(*frame) : QStringLiteral("T ") + none);
    set(kBlock,
        tr("Block %1 / %2").arg(number(frame ? frame->block : 0), number(m_session.program().blockCount())));
    set(kFaces, tr("Triangles %1").arg(frame ? number(frame->surface.faces) : QStringLiteral("–")));
}

QString StatusLine::toolText(const Frame& frame) const {
    const bool present = frame.tool != 0 || frame.setup->tools.find(0) != nullptr;
    const QString text = QStringLiteral("T ") + (present ? QString::number(frame.tool) : QStringLiteral("–"));
    return frame.toolAssumed ? assumedText(text) : text;
}

void StatusLine::showWork() {
    const std::optional<Work>& work = m_session.work().current();
    m_progress->setVisible(work.has_value());
    m_cancel->setVisible(work.has_value() && work->cancellable);
    if (!work)
        return;
    // The label is inside the bar: next to it, it would force a narrow window to grow while the work runs.
    const QString text = work->secondsLeft
                             ? tr("%1 · %2 left").arg(work->label, minutesText(*work->secondsLeft))
                             : work->label;
    if (m_progress->format() != text) {
        m_progress->setFormat(text);
        m_progress->setFixedWidth(
            std::max(kProgressWidth, m_progress->fontMetrics().horizontalAdvance(text) + kProgressMargin));
    }
    m_progress->setValue(static_cast<int>(work->done * kProgressSteps));
}

} // namespace proveout
