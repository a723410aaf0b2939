// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/status_line.h"

#include <algorithm>

#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QStatusBar>
#include <QToolButton>

#include "ui/export_text.h"

namespace proveout {

namespace {

constexpr int kProgressWidth = 140;
constexpr int kProgressSteps = 100;
/// The widest text of each field, in the order of the fields.
constexpr std::array<const char*, 8> kWidest{"X -0000.000",     "Y -0000.000",    "Z -0000.000",
                                             "F 00000",         "S 00000",        "T 000",
                                             "Block 000 / 000", "Faces 0,000,000"};

QString millimetres(const QLocale& locale, double value) {
    return locale.toString(value, 'f', 3);
}

/// As the program writes it: F and S are words, not amounts.
QString wordValue(QLocale locale, double value) {
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(value, 'g', 6);
}

/// The motion that the frame stands after.
Motion lastMotion(const Frame& frame) {
    return frame.program->motion(frame.program->blockMotions(frame.block - 1).last - 1);
}

} // namespace

StatusLine::StatusLine(Session& session, QStatusBar& bar)
    : QObject(&bar), m_session(session), m_bar(bar), m_workLabel(new QLabel(&bar)),
      m_progress(new QProgressBar(&bar)), m_cancel(new QToolButton(&bar)) {
    bar.addPermanentWidget(m_workLabel);
    bar.addPermanentWidget(m_progress);
    bar.addPermanentWidget(m_cancel);
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        m_fields[i] = new QLabel(&bar);
        m_fields[i]->setFixedWidth(bar.fontMetrics().horizontalAdvance(QLatin1String(kWidest[i])) + 6);
        bar.addPermanentWidget(m_fields[i]);
    }
    m_progress->setRange(0, kProgressSteps);
    m_progress->setFixedWidth(kProgressWidth);
    m_progress->setTextVisible(false);
    m_cancel->setAutoRaise(true);
    connect(m_cancel, &QToolButton::clicked, &session, &Session::cancelWork);
    connect(&session, &Session::tick, this, &StatusLine::onTick);
    connect(&session, &Session::programChanged, this, &StatusLine::fitBlockField);
    connect(&session, &Session::workChanged, &session, &Session::requestTick);
    connect(&bar, &QStatusBar::messageChanged, &bar, [&bar] { bar.setToolTip({}); });
    connect(&session, &Session::exported, this, [this](const ExportSummary& summary) {
        const QString text = exportText(summary, m_bar.locale());
        m_bar.showMessage(text);
        // A narrow window cuts the message off.
        m_bar.setToolTip(text + QLatin1Char('\n') + exportDetails(summary, m_bar.locale()));
    });
    retranslate();
}

void StatusLine::retranslate() {
    m_cancel->setText(tr("Cancel"));
    m_cancel->setToolTip(tr("Stop this work"));
    const std::array<QString, kFieldCount> tips{tr("Position X of the tip of the cutter, mm"),
                                                tr("Position Y of the tip of the cutter, mm"),
                                                tr("Position Z of the tip of the cutter, mm"),
                                                tr("Feed, mm/min"),
                                                tr("Spindle speed, 1/min"),
                                                tr("Tool in the spindle"),
                                                tr("Blocks executed of those that move"),
                                                tr("Triangles shown")};
    for (std::size_t i = 0; i < m_fields.size(); ++i)
        m_fields[i]->setToolTip(tips[i]);
    fitFeedField();
    fitBlockField();
    showFrame(m_session.frame());
    showWork();
}

void StatusLine::fitFeedField() {
    const int rapid = m_bar.fontMetrics().horizontalAdvance(tr("F rapid"));
    m_fields[kFeed]->setFixedWidth(std::max(m_fields[kFeed]->width(), rapid + 6));
}

void StatusLine::fitBlockField() {
    // As wide as the last block needs it, so that it stays while the number grows.
    const QString last = m_bar.locale().toString(static_cast<qulonglong>(m_session.blockCount()));
    m_fields[kBlock]->setFixedWidth(
        m_bar.fontMetrics().horizontalAdvance(tr("Block %1 / %2").arg(last, last)) + 6);
}

void StatusLine::onTick(const FramePtr& frame) {
    showWork();
    // At every tick, like all other panels: two counts of one moment must be the same.
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
    const Vec3 position = frame ? frame->cutterPosition : Vec3(0);
    set(kX, axis("X ", position.x));
    set(kY, axis("Y ", position.y));
    set(kZ, axis("Z ", position.z));
    const Motion motion = executed ? lastMotion(*frame) : Motion();
    const QString none = QStringLiteral("–");
    set(kFeed, executed && motion.kind == MotionKind::rapid
                   ? tr("F rapid")
                   : QStringLiteral("F ") + (executed ? wordValue(locale, motion.feedMmPerMin) : none));
    set(kSpindle, QStringLiteral("S ") + (executed ? wordValue(locale, motion.spindleRpm) : none));
    set(kTool, QStringLiteral("T ") + (frame && frame->tool != 0 ? QString::number(frame->tool) : none));
    set(kBlock, tr("Block %1 / %2").arg(number(frame ? frame->block : 0), number(m_session.blockCount())));
    set(kFaces, tr("Faces %1").arg(frame ? number(frame->surface.faces) : QStringLiteral("–")));
}

void StatusLine::showWork() {
    const std::optional<Work>& work = m_session.work();
    m_workLabel->setVisible(work.has_value());
    m_progress->setVisible(work.has_value());
    m_cancel->setVisible(work.has_value());
    if (!work)
        return;
    if (m_workLabel->text() != work->label)
        m_workLabel->setText(work->label);
    m_progress->setValue(static_cast<int>(work->done * kProgressSteps));
}

} // namespace proveout
