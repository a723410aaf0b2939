// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/verdict_badge.h"

#include <algorithm>

#include <QEvent>
#include <QPainter>

#include "ui/look/icons.h"
#include "ui/look/theme.h"
#include "ui/readout/verdict_text.h"
#include "ui/session/session.h"

namespace proveout {

namespace {

// px
constexpr int kIconSize = 16;
constexpr int kPadding = 10; ///< left of the icon and right of the words
constexpr int kGap = 4;
constexpr int kAround = 2;
constexpr int kRound = 4;

const char* iconOf(VerdictState state) {
    switch (state) {
    case VerdictState::safe:
        return "safe";
    case VerdictState::faults:
        return "fault";
    case VerdictState::unverified:
    case VerdictState::refused:
        return "help";
    case VerdictState::none:
    case VerdictState::checking:
        break;
    }
    return "find";
}

/// Invalid: no fill.
QColor fillOf(VerdictState state, const MeaningColors& colors) {
    switch (state) {
    case VerdictState::safe:
        return colors.safe;
    case VerdictState::faults:
        return colors.error;
    case VerdictState::unverified:
    case VerdictState::refused:
        return colors.warning;
    case VerdictState::none:
    case VerdictState::checking:
        break;
    }
    return {};
}

} // namespace

VerdictBadge::VerdictBadge(const Session& session, QWidget* parent)
    : QToolButton(parent), m_session(session) {
    setObjectName(QStringLiteral("verdict"));
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setFocusPolicy(Qt::TabFocus);
    connect(&session.check(), &CheckHub::changed, this, &VerdictBadge::showVerdict);
    connect(&session.check(), &CheckHub::progressed, this, &VerdictBadge::showText);
    QFont bold = font();
    bold.setBold(true);
    setFont(bold);
    showVerdict();
}

bool VerdictBadge::hasVerdict() const {
    return verdictState(m_session.check()) != VerdictState::none;
}

void VerdictBadge::showVerdict() {
    showText();
    const QStringList reasons = verdictReasons(m_session.check(), locale());
    QString tip;
    for (const QString& reason : reasons)
        tip += QStringLiteral("<p>%1</p>").arg(reason.toHtmlEscaped());
    tip += QStringLiteral("<p>%1</p>").arg(tr("Click to see all findings.").toHtmlEscaped());
    setToolTip(tip);
    setAccessibleDescription(reasons.join(u'\n'));
    update();
    emit shown();
}

void VerdictBadge::showText() {
    setText(verdictText(m_session.check(), locale()));
    updateGeometry();
    setAccessibleName(tr("Verdict: %1").arg(text()));
}

QSize VerdictBadge::sizeHint() const {
    const QFontMetrics metrics = fontMetrics();
    return {kIconSize + metrics.horizontalAdvance(text()) + kGap + 2 * (kPadding + kAround),
            std::max(kIconSize, metrics.height()) + 2 * (kGap + kAround)};
}

void VerdictBadge::paintEvent(QPaintEvent*) {
    const VerdictState state = verdictState(m_session.check());
    const QColor fill = fillOf(state, meaningColors(palette()));
    const QColor words = palette().color(fill.isValid() ? QPalette::Base : QPalette::WindowText);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(hasFocus() || underMouse() ? palette().color(QPalette::WindowText)
                   : fill.isValid()           ? fill
                                              : palette().color(QPalette::Mid));
    painter.setBrush(fill.isValid() ? QBrush(fill) : QBrush());
    const QRect pill = rect().adjusted(kAround, kAround, -kAround, -kAround);
    painter.drawRoundedRect(QRectF(pill).adjusted(0.5, 0.5, -0.5, -0.5), kRound, kRound);
    const QRect inside = pill.adjusted(kPadding, 0, -kPadding, 0);
    const QRect icon(inside.left(), inside.center().y() - kIconSize / 2, kIconSize, kIconSize);
    proveout::icon(QLatin1String(iconOf(state)), words).paint(&painter, icon);
    painter.setPen(words);
    painter.drawText(inside.adjusted(kIconSize + kGap, 0, 0, 0), Qt::AlignVCenter | Qt::AlignLeft, text());
}

void VerdictBadge::changeEvent(QEvent* event) {
    QToolButton::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        showVerdict();
}

} // namespace proveout
