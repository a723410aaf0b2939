// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editor/problem_marks.h"

#include <algorithm>
#include <array>
#include <map>

#include <QApplication>
#include <QImage>
#include <QPixmap>
#include <QStringList>
#include <Qsci/qsciscintilla.h>

#include "ui/look/diagnostic_text.h"
#include "ui/look/icons.h"
#include "ui/look/theme.h"

namespace proveout {

namespace {

using Scintilla = QsciScintilla;

constexpr int kErrorSquiggle = 8; // 0 … 7 are reserved for lexers
constexpr int kWarningSquiggle = 9;
constexpr int kFirstMark = 8; // 0 … 7 are reserved for other markers
constexpr int kMarkSize = 13;
constexpr int kMarginWidth = 16;
constexpr int kMostMargins = 5;
constexpr std::size_t kMostShown = 1000;
constexpr std::array kSeverities{Severity::note, Severity::warning, Severity::error, Severity::fault};

constexpr int markOf(Severity severity) {
    return kFirstMark + static_cast<int>(severity);
}

constexpr unsigned kMarks = [] {
    unsigned marks = 0;
    for (const Severity severity : kSeverities)
        marks |= 1U << markOf(severity);
    return marks;
}();

} // namespace

ProblemMarks::ProblemMarks(QsciScintilla& text, int margin) : m_text(text), m_margin(margin) {
    text.setMarginType(margin, Scintilla::SymbolMargin);
    text.setMarginWidth(margin, kMarginWidth);
    text.setMarginMarkerMask(margin, static_cast<int>(kMarks));
    text.indicatorDefine(Scintilla::SquiggleIndicator, kErrorSquiggle);
    text.indicatorDefine(Scintilla::SquiggleIndicator, kWarningSquiggle);
}

void ProblemMarks::adoptPalette() {
    const MeaningColors meaning = meaningColors(QApplication::palette());
    m_text.setIndicatorForegroundColor(meaning.error, kErrorSquiggle);
    m_text.setIndicatorForegroundColor(meaning.warning, kWarningSquiggle);
    const double ratio = m_text.devicePixelRatioF();
    for (const Severity severity : kSeverities) {
        const QPixmap picture = icon(QLatin1String(name(severity)), severityColor(meaning, severity))
                                    .pixmap(QSize(kMarkSize, kMarkSize), ratio);
        m_text.SendScintilla(Scintilla::SCI_RGBAIMAGESETSCALE, static_cast<unsigned long>(100 * ratio));
        m_text.markerDefine(picture.toImage(), markOf(severity));
    }
}

void ProblemMarks::show(const Diagnostics& problems) {
    m_problems.clear();
    removeMarks();
    for (const int squiggle : {kErrorSquiggle, kWarningSquiggle}) {
        m_text.SendScintilla(Scintilla::SCI_SETINDICATORCURRENT, static_cast<unsigned long>(squiggle));
        m_text.SendScintilla(Scintilla::SCI_INDICATORCLEARRANGE, 0UL,
                             m_text.SendScintilla(Scintilla::SCI_GETLENGTH));
    }
    std::map<int, Severity> worst;
    for (const Diagnostic& problem : problems) {
        if (problem.where.line <= 0 || problem.where.line > m_text.lines() || m_problems.size() == kMostShown)
            continue;
        m_problems.push_back(problem);
        const bool serious = problem.severity >= Severity::error;
        const auto [from, to] = rangeOf(problem);
        m_text.SendScintilla(Scintilla::SCI_SETINDICATORCURRENT,
                             static_cast<unsigned long>(serious ? kErrorSquiggle : kWarningSquiggle));
        m_text.SendScintilla(Scintilla::SCI_INDICATORFILLRANGE, static_cast<unsigned long>(from), to - from);
        Severity& mark = worst.emplace(problem.where.line, problem.severity).first->second;
        mark = std::max(mark, problem.severity);
    }
    for (const auto& [line, severity] : worst) {
        m_text.markerAdd(line - 1, markOf(severity));
        m_marked.push_back(line - 1);
    }
}

void ProblemMarks::clear() {
    m_problems.clear();
    m_marked.clear();
}

/// Removing by kind makes Scintilla search all lines once per kind. If every mark is still where it was set,
/// removing them line by line is enough, because an edit moves or joins marks but never adds one.
void ProblemMarks::removeMarks() {
    bool moved = false;
    for (const int line : m_marked) {
        moved = moved || (m_text.markersAtLine(line) & kMarks) == 0;
        for (const Severity severity : kSeverities)
            m_text.markerDelete(line, markOf(severity));
    }
    m_marked.clear();
    for (const Severity severity : kSeverities) {
        if (moved)
            m_text.markerDeleteAll(markOf(severity));
    }
}

std::pair<long, long> ProblemMarks::rangeOf(const Diagnostic& problem) const {
    const auto line = static_cast<unsigned long>(problem.where.line - 1);
    const long begin = m_text.SendScintilla(Scintilla::SCI_POSITIONFROMLINE, line);
    const long end = m_text.SendScintilla(Scintilla::SCI_GETLINEENDPOSITION, line);
    const long from = std::min(end, begin + std::max(0, problem.where.column - 1));
    const long length = problem.where.length > 0 ? problem.where.length : end - from;
    // A message at the end of a line still needs a character to underline.
    const long to = std::min(end, from + length);
    return to > from ? std::pair(from, to) : std::pair(begin, end);
}

bool ProblemMarks::isInMargins(QPoint place) const {
    int width = 0;
    for (int margin = 0; margin < kMostMargins; ++margin)
        width += m_text.marginWidth(margin);
    return place.x() < width;
}

int ProblemMarks::lineAt(QPoint place) const {
    const auto position = static_cast<unsigned long>(m_text.SendScintilla(
        Scintilla::SCI_POSITIONFROMPOINT, static_cast<unsigned long>(std::max(0, place.x())), place.y()));
    const long line = m_text.SendScintilla(Scintilla::SCI_LINEFROMPOSITION, position);
    // For a position below the last line Scintilla returns the last line.
    const long top =
        m_text.SendScintilla(Scintilla::SCI_POINTYFROMPOSITION, 0UL, static_cast<long>(position));
    const long height = m_text.SendScintilla(Scintilla::SCI_TEXTHEIGHT, static_cast<unsigned long>(line));
    return place.y() < top + height ? static_cast<int>(line) + 1 : 0;
}

QString ProblemMarks::tipAt(QPoint place) const {
    const bool wholeLine = isInMargins(place);
    const int line = wholeLine ? lineAt(place) : 0;
    const long position =
        wholeLine ? -1
                  : m_text.SendScintilla(Scintilla::SCI_POSITIONFROMPOINTCLOSE,
                                         static_cast<unsigned long>(std::max(0, place.x())), place.y());
    QStringList sentences;
    for (const Diagnostic& problem : m_problems) {
        const auto [from, to] = rangeOf(problem);
        const bool here =
            wholeLine ? problem.where.line == line : position >= 0 && position >= from && position <= to;
        if (!here)
            continue;
        sentences << QStringLiteral("%1: %2").arg(severityName(problem.severity), sentence(problem));
        if (!hint(problem).isEmpty())
            sentences << hint(problem);
    }
    return sentences.join(u'\n');
}

} // namespace proveout
