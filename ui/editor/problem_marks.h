// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include <QPoint>
#include <QString>

#include "core/base/diagnostic.h"

class QsciScintilla;

namespace proveout {

/// Problems in a text: a squiggle under the place, and in the margin of the line the icon of the worst one,
/// a shape for each severity. Thread: UI.
class ProblemMarks {
public:
    /// `text` outlives this object; the icons stand in its margin number `margin`.
    ProblemMarks(QsciScintilla& text, int margin);

    /// Takes the colours of the application's palette.
    void adoptPalette();
    void show(const Diagnostics& problems);
    /// Forgets them: the text has been replaced.
    void clear();
    /// What is told at a place of the viewport: of the squiggle there, or of the whole line in the margins.
    /// Empty where there is nothing.
    [[nodiscard]] QString tipAt(QPoint place) const;
    /// Whether a place of the viewport is left of the text.
    [[nodiscard]] bool isInMargins(QPoint place) const;

private:
    void removeMarks();
    [[nodiscard]] std::pair<long, long> rangeOf(const Diagnostic& problem) const;
    [[nodiscard]] int lineAt(QPoint place) const; ///< 1-based; 0: none

    QsciScintilla& m_text;
    int m_margin;
    Diagnostics m_problems;
    std::vector<int> m_marked; ///< lines (0-based), each once, as they were when they were marked
};

} // namespace proveout
