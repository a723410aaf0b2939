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
#include "ui/work/newest_task.h"

namespace proveout {

/// The text of an NC program as bytes, with line numbers, the current block and its problems.
/// Playback moves a marker and the first visible line, never the caret.
class NcEditor final : public QsciScintilla {
    Q_OBJECT

public:
    explicit NcEditor(QWidget* parent = nullptr);

    /// Shows a document from its first line; the undo history begins anew. A long text is read in the
    /// background from the immutable `document.text`: until then there is none, and nothing can be edited.
    void load(const Document& document);
    /// Whether the text is still to come.
    [[nodiscard]] bool isFilling() const { return m_isFilling; }
    /// From now on "not modified" means the present text.
    void markSaved();
    /// Marks the line (1-based, 0: none) of the block that was executed last, and shows it where `follow`.
    void showCurrentLine(int line, bool follow);
    /// Scrolls to the line that is marked.
    void revealCurrentLine();
    /// Colours the codes of this dialect as known ones.
    void showDialect(DialectId dialect);
    /// Lines (1-based) with breakpoints, those that are on and those that are off.
    void showBreakpoints(const std::vector<int>& on, const std::vector<int>& off);
    void showProblems(const Diagnostics& problems) { m_problems.show(problems); }
    /// The values of a line, for the tooltip that shows one of its words, now or until the text changes.
    void showValues(std::shared_ptr<const LineValues> values);
    /// Puts the caret on a place (1-based) and shows it, once the text is there.
    void goTo(int line, int column);
    [[nodiscard]] int caretLine() const; ///< 1-based
    /// Pixels that show `columns` characters of a line, with margins and scroll bar.
    [[nodiscard]] int widthOf(std::size_t columns) const;
    /// The text, until the next change of it.
    [[nodiscard]] std::string_view textBytes() const;
    /// A text of the user in the encoding of the document.
    [[nodiscard]] std::string encoded(const QString& text) const;
    /// The bytes [first, second) that are selected; both are the caret's place where none are.
    [[nodiscard]] std::pair<std::size_t, std::size_t> selectedBytes() const;
    /// Selects the bytes [begin, end) and shows them.
    void selectBytes(std::size_t begin, std::size_t end);
    /// Replaces the bytes [begin, end) as one step of undo; what is seen of the text stays.
    void replaceBytes(std::size_t begin, std::size_t end, std::string_view text);

signals:
    /// The user types, clicks or scrolls, or was led to a place here: the text is not to scroll by itself.
    void worked();
    /// The margin beside a line (1-based) was clicked.
    void marginChosen(int line);
    /// The user added (or took away) lines behind a place in `line` (1-based).
    void linesMoved(std::uint32_t line, bool fromItsStart, std::ptrdiff_t added);
    /// Another text is there, also the empty one before a long one.
    void loaded();
    /// The user replaced `removed` bytes at `offset`.
    void edited(std::size_t offset, std::size_t removed, std::string_view inserted);
    void savedStateChanged(bool modified);
    /// The mouse rests on a word of a line (1-based), or does no longer.
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
    /// Files are dropped on the window, not into the text.
    [[nodiscard]] bool canInsertFromMimeData(const QMimeData* source) const override;

private:
    void showDocument(std::shared_ptr<const ScintillaDocument> shown, const Document& document,
                      bool readOnly);
    void setUpMargins();
    void adoptPalette();
    void onModified(int position, int type, const char* text, int length, int linesAdded);
    bool showTip(QPoint place, QPoint globalPlace);
    /// A word that is pointed at.
    struct PointedWord {
        WordHelp help;
        std::uint32_t line = 0; ///< 1-based
        QRect place;            ///< in the viewport
    };
    struct Tip {
        QString problems;
        PointedWord word;
        QPoint place; ///< on the screen
    };
    [[nodiscard]] std::optional<PointedWord> wordAt(QPoint place) const;
    void showWordTip();
    void leaveWord();
    void revealLine(int line);

    NcHighlighter m_highlighter;
    ProblemMarks m_problems;
    std::shared_ptr<const ScintillaDocument> m_document; ///< what is shown; null before the first one
    bool m_loading = false;
    bool m_isFilling = false;
    std::optional<std::pair<int, int>> m_place; ///< to go to when the text is there
    bool m_edited = false;                      ///< since the key that is being handled went down
    int m_currentLine = 0;
    std::optional<Tip> m_tip; ///< of a word, as long as it may be shown
    std::shared_ptr<const LineValues> m_values;
    NewestTask m_filling; ///< fills a document that no view shows yet
};

} // namespace proveout
