// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include <QPoint>
#include <QString>

#include "core/base/diagnostic.h"

class QsciScintilla;

namespace proveout {

/// Problems in a text: a squiggle under the position, and in the margin of the line the icon of the most
/// severe problem, with a different shape for each severity. Thread: UI.
class ProblemMarks {
public:
    /// `text` must outlive this object; the icons are shown in its margin number `margin`.
    ProblemMarks(QsciScintilla& text, int margin);

    /// Uses the colours of the application's palette.
    void adoptPalette();
    void show(const Diagnostics& problems);
    /// Clears all problems because the text has been replaced.
    void clear();
    /// The tooltip text at a position of the viewport: of the squiggle there, or of the whole line in the
    /// margins. Empty if there is none.
    [[nodiscard]] QString tipAt(QPoint place) const;
    /// Whether a position of the viewport is left of the text.
    [[nodiscard]] bool isInMargins(QPoint place) const;

private:
    void removeMarks();
    [[nodiscard]] std::pair<long, long> rangeOf(const Diagnostic& problem) const;
    [[nodiscard]] int lineAt(QPoint place) const; ///< 1-based; 0: none

    QsciScintilla& m_text;
    int m_margin;
    Diagnostics m_problems;
    std::vector<int> m_marked; ///< lines (0-based) as they were when marked, without duplicates
};

} // namespace proveout
