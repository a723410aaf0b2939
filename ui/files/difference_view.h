// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include <QPlainTextEdit>

#include "core/base/line_diff.h"
#include "core/nc/text/nc_text.h"

namespace proveout {

/// A read-only view of the differences between two texts in one column: lines that only the first or only the
/// second has, and a few lines that both have. Each line has its number in both texts and a sign, so that the
/// difference does not depend on colour alone.
class DifferenceView final : public QPlainTextEdit {
    Q_OBJECT

public:
    explicit DifferenceView(QWidget* parent);

    /// Shows at most `mostLines` lines.
    void show(const NcText& before, const NcText& after, int mostLines);
    using QPlainTextEdit::show;

    [[nodiscard]] std::size_t changeCount() const { return m_changes.size(); }
    [[nodiscard]] std::size_t removedLines() const;
    [[nodiscard]] std::size_t addedLines() const;
    /// Whether some lines were not shown because of the limit.
    [[nodiscard]] bool isCut() const { return m_cut; }
    /// Scrolls to the next difference, or with -1 to the previous one.
    void go(int direction);

protected:
    void changeEvent(QEvent* event) override;

private:
    enum class Kind { both, removed, added, gap };
    struct Line {
        Kind kind = Kind::both;
        std::size_t before = 0; ///< 1-based; 0: none
        std::size_t after = 0;
        QString text;
    };

    void collect(const NcText& before, const NcText& after, int mostLines);
    void add(Kind kind, std::size_t before, std::size_t after, std::string_view text);
    void fill();

    std::vector<LineChange> m_changes;
    std::vector<Line> m_lines;
    std::vector<int> m_starts; ///< the first line of each difference
    bool m_cut = false;
};

} // namespace proveout
