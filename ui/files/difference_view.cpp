// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/difference_view.h"

#include <algorithm>
#include <numeric>

#include <QEvent>
#include <QFontDatabase>
#include <QTextBlock>

#include "core/base/utf8.h"
#include "ui/document/document.h"
#include "ui/look/theme.h"

namespace proveout {

namespace {

constexpr std::size_t kContext = 3;       ///< equal lines before and after a difference
constexpr std::size_t kLongestLine = 400; ///< bytes; the rest of a line is not shown

std::vector<std::string_view> linesOf(const NcText& text) {
    std::vector<std::string_view> lines(text.lineCount());
    for (std::size_t i = 0; i < lines.size(); ++i)
        lines[i] = text.line(i);
    return lines;
}

QString shown(std::string_view line) {
    const std::string_view head = line.substr(0, kLongestLine);
    const auto size = static_cast<qsizetype>(head.size());
    QString text =
        isUtf8(line) ? QString::fromUtf8(head.data(), size) : QString::fromLatin1(head.data(), size);
    return head.size() < line.size() ? text + QChar(0x2026) : text;
}

QString number(std::size_t line, int width) {
    return (line == 0 ? QString() : QString::number(line)).rightJustified(width);
}

QColor mixed(const QColor& base, const QColor& with, double share) {
    const auto mix = [share](float a, float b) { return static_cast<float>(a + (b - a) * share); };
    return QColor::fromRgbF(mix(base.redF(), with.redF()), mix(base.greenF(), with.greenF()),
                            mix(base.blueF(), with.blueF()));
}

} // namespace

DifferenceView::DifferenceView(QWidget* parent) : QPlainTextEdit(parent) {
    setReadOnly(true);
    setLineWrapMode(NoWrap);
    setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
}

std::size_t DifferenceView::removedLines() const {
    return std::transform_reduce(m_changes.begin(), m_changes.end(), std::size_t{0}, std::plus(),
                                 [](const LineChange& each) { return each.beforeLast - each.beforeFirst; });
}

std::size_t DifferenceView::addedLines() const {
    return std::transform_reduce(m_changes.begin(), m_changes.end(), std::size_t{0}, std::plus(),
                                 [](const LineChange& each) { return each.afterLast - each.afterFirst; });
}

void DifferenceView::show(const NcText& before, const NcText& after, int mostLines) {
    collect(before, after, mostLines);
    fill();
}

void DifferenceView::add(Kind kind, std::size_t before, std::size_t after, std::string_view text) {
    m_lines.push_back({kind, before, after, shown(text)});
}

void DifferenceView::collect(const NcText& before, const NcText& after, int mostLines) {
    const std::vector<std::string_view> old = linesOf(before);
    const std::vector<std::string_view> now = linesOf(after);
    m_changes = compareLines(old, now);
    m_lines.clear();
    m_starts.clear();
    m_cut = false;
    std::size_t at = 0; // old lines up to here are shown already
    const auto isFull = [&] { return static_cast<int>(m_lines.size()) >= mostLines; };
    for (std::size_t c = 0; c < m_changes.size() && !m_cut; ++c) {
        const LineChange& change = m_changes[c];
        const std::size_t context = std::min(kContext, change.beforeFirst - at);
        if (change.beforeFirst - context > at || (c == 0 && context < change.beforeFirst))
            add(Kind::gap, 0, 0, {});
        const std::size_t shift = change.afterFirst - change.beforeFirst; // modulo 2⁶⁴
        for (std::size_t i = change.beforeFirst - context; i < change.beforeFirst; ++i)
            add(Kind::both, i + 1, i + shift + 1, old[i]);
        m_starts.push_back(static_cast<int>(m_lines.size()));
        for (std::size_t i = change.beforeFirst; i < change.beforeLast && !isFull(); ++i)
            add(Kind::removed, i + 1, 0, old[i]);
        for (std::size_t i = change.afterFirst; i < change.afterLast && !isFull(); ++i)
            add(Kind::added, 0, i + 1, now[i]);
        m_cut = isFull();
        const std::size_t next = c + 1 < m_changes.size() ? m_changes[c + 1].beforeFirst : old.size();
        at = std::min(change.beforeLast + kContext, next);
        for (std::size_t i = change.beforeLast; i < at && !m_cut; ++i)
            add(Kind::both, i + 1, i + change.afterLast - change.beforeLast + 1, old[i]);
    }
}

void DifferenceView::fill() {
    std::size_t last = 1;
    for (const Line& line : m_lines)
        last = std::max({last, line.before, line.after});
    const int width = static_cast<int>(QString::number(last).size());
    const QColor base = palette().color(QPalette::Base);
    const double share = isDark(palette()) ? 0.28 : 0.18;
    QTextBlockFormat plain;
    QTextBlockFormat removed;
    removed.setBackground(mixed(base, QColor(0xe0, 0x30, 0x30), share));
    QTextBlockFormat added;
    added.setBackground(mixed(base, QColor(0x20, 0xa0, 0x40), share));
    QTextCharFormat dimmed;
    dimmed.setForeground(palette().color(QPalette::PlaceholderText));
    clear();
    QTextCursor cursor(document());
    cursor.beginEditBlock();
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        const Line& line = m_lines[i];
        const QTextBlockFormat& format = line.kind == Kind::removed ? removed
                                         : line.kind == Kind::added ? added
                                                                    : plain;
        if (i == 0)
            cursor.setBlockFormat(format);
        else
            cursor.insertBlock(format);
        if (line.kind == Kind::gap) {
            cursor.insertText(QString(width, u' ') + QChar(0x22EE), dimmed);
            continue;
        }
        const QString sign = line.kind == Kind::removed ? QString(QChar(0x2212))
                             : line.kind == Kind::added ? QStringLiteral("+")
                                                        : QStringLiteral(" ");
        cursor.insertText(number(line.before, width) + u' ' + number(line.after, width) + u' ', dimmed);
        cursor.insertText(sign + u' ' + line.text, QTextCharFormat());
    }
    cursor.endEditBlock();
    moveCursor(QTextCursor::Start);
}

void DifferenceView::go(int direction) {
    const int here = textCursor().blockNumber();
    const auto next = std::ranges::upper_bound(m_starts, here);
    auto wanted = next;
    if (direction < 0) {
        wanted = std::ranges::lower_bound(m_starts, here);
        if (wanted == m_starts.begin())
            return;
        --wanted;
    }
    if (wanted == m_starts.end())
        return;
    setTextCursor(QTextCursor(document()->findBlockByNumber(*wanted)));
    centerCursor();
}

void DifferenceView::changeEvent(QEvent* event) {
    QPlainTextEdit::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        fill();
}

} // namespace proveout
