// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Qsci/qsciscintilla.h>

#include "core/base/diagnostic.h"
#include "core/nc/codes/word_help.h"
#include "core/nc/program/line_values.h"
#include "ui/document/document.h"
#include "ui/editor/nc_highlighter.h"
#include "ui/editor/problem_marks.h"
#include "ui/editor/scintilla_document.h"
#include "ui/editor/text_edits.h"
#include "ui/work/newest_task.h"

namespace proveout {

/// The text of an NC program as bytes, with line numbers, the current block and its problems. Playback moves
/// a marker and scrolls the text, but never moves the cursor.
class NcEditor final : public ObservedScintilla {
    Q_OBJECT

public:
    explicit NcEditor(QWidget* parent = nullptr);

    /// Shows a document from its first line and clears the undo history. A long text is read in the
    /// background from the immutable `document.text`; until then the editor is empty and read-only.
    void load(const Document& document);
    /// Whether the text is still being loaded.
    [[nodiscard]] bool isFilling() const { return m_isFilling; }
    /// The current text now counts as saved.
    void markSaved();
    /// Marks the line (1-based, 0: none) of the last executed block, and scrolls to it if `follow` is set.
    void showCurrentLine(int line, bool follow);
    /// Scrolls to the marked line.
    void revealCurrentLine();
    /// Colours the codes of this dialect as supported.
    void showDialect(DialectId dialect);
    /// Lines (1-based) with enabled breakpoints and with disabled ones.
    void showBreakpoints(const std::vector<int>& on, const std::vector<int>& off);
    void showProblems(const Diagnostics& problems) { m_problems.show(problems); }
    /// The values of a line, for the tooltip of one of its words. They are used until the text changes.
    void showValues(std::shared_ptr<const LineValues> values);
    /// Moves the cursor to a position (1-based) and scrolls to it, as soon as the text is loaded.
    void goTo(int line, int column);
    [[nodiscard]] int caretLine() const; ///< 1-based
    /// Width in pixels that shows `columns` characters of a line, including margins and scroll bar.
    [[nodiscard]] int widthOf(std::size_t columns) const;
    /// The text; valid until it changes.
    [[nodiscard]] std::string_view textBytes() const;
    /// Converts text entered by the user to the encoding of the document.
    [[nodiscard]] std::string encoded(const QString& text) const;
    /// The selected bytes [first, second); both are the cursor position if nothing is selected.
    [[nodiscard]] std::pair<std::size_t, std::size_t> selectedBytes() const;
    /// Selects the bytes [begin, end) and scrolls to them.
    void selectBytes(std::size_t begin, std::size_t end);
    /// Replaces the bytes [begin, end) as one undo step; the scroll position stays.
    void replaceBytes(std::size_t begin, std::size_t end, std::string_view text);

signals:
    /// The user types, clicks or scrolls, or a command moves the cursor: the text must not scroll by itself.
    void worked();
    /// The user clicked the margin next to a line (1-based).
    void marginChosen(int line);
    /// The user added (or removed) lines after a position in `line` (1-based).
    void linesMoved(std::uint32_t line, bool fromItsStart, std::ptrdiff_t added);
    /// Another text is shown; also emitted for the empty text that precedes a long one.
    void loaded();
    /// The user replaced `removed` bytes at `offset`.
    void edited(std::size_t offset, std::size_t removed, std::string_view inserted);
    void savedStateChanged(bool modified);
    /// The mouse rests on a word of a line (1-based), or no longer does.
    void valuesWanted(std::uint32_t line);
    void valuesUnwanted();
    /// The user moved the caret to another line (1-based) without editing.
    void lineChosen(int line);

protected:
    bool event(QEvent* event) override;
    bool viewportEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void changeEvent(QEvent* event) override;
    /// Rejects files: they are dropped on the window, not into the text.
    [[nodiscard]] bool canInsertFromMimeData(const QMimeData* source) const override;

private:
    void showDocument(std::shared_ptr<const ScintillaDocument> shown, const Document& document,
                      bool readOnly);
    void setUpMargins();
    void adoptPalette();
    void onEdit(const TextEdit& edit);
    bool showTip(QPoint place, QPoint globalPlace);
    /// The word under the mouse.
    struct PointedWord {
        WordHelp help;
        std::uint32_t line = 0; ///< 1-based
        QRect place;            ///< rectangle in the viewport
    };
    struct Tip {
        QString problems;
        PointedWord word;
        QPoint place; ///< position on the screen
    };
    [[nodiscard]] std::optional<PointedWord> wordAt(QPoint place) const;
    void showWordTip();
    void leaveWord();
    void revealLine(int line);

    NcHighlighter m_highlighter;
    ProblemMarks m_problems;
    std::shared_ptr<const ScintillaDocument> m_document; ///< in the view; null before the first one
    bool m_loading = false;
    bool m_isFilling = false;
    std::optional<std::pair<int, int>> m_place; ///< position to move to when the text is loaded
    bool m_edited = false;                      ///< since the last key press
    int m_currentLine = 0;
    std::optional<Tip> m_tip; ///< the tooltip of a word, while it may be shown
    std::shared_ptr<const LineValues> m_values;
    NewestTask m_filling; ///< fills a document before a view shows it
};

} // namespace proveout
