// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editor/editor_search.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "ui/editor/nc_editor.h"
#include "ui/editor/text_edits.h"

namespace proveout {

namespace {
constexpr int kRestMs = 120;
/// Replaced at once: a few milliseconds.
constexpr std::size_t kPart = std::size_t{1} << 18; // bytes

/// Makes one undo step of all edits while it exists; the text is not painted meanwhile.
class OneUndoStep {
public:
    explicit OneUndoStep(NcEditor& editor)
        : m_editor(editor),
          m_loaded(QObject::connect(&editor, &NcEditor::loaded, [this] { m_isOther = true; })) {
        m_editor.setUpdatesEnabled(false);
        m_editor.beginUndoAction();
    }
    OneUndoStep(const OneUndoStep&) = delete;
    OneUndoStep& operator=(const OneUndoStep&) = delete;
    ~OneUndoStep() {
        QObject::disconnect(m_loaded);
        if (!m_isOther) {
            m_editor.endUndoAction();
            if (m_reverts)
                m_editor.undo();
        }
        m_editor.setUpdatesEnabled(true);
    }
    /// Undoes it at its end. Only if there was an edit: otherwise that would be the step before.
    void revert() { m_reverts = true; }
    /// Whether another text is shown now, so that the step is gone.
    [[nodiscard]] bool isGone() const { return m_isOther; }

private:
    NcEditor& m_editor;
    QMetaObject::Connection m_loaded;
    bool m_isOther = false;
    bool m_reverts = false;
};

/// The start of the line after that of a position, or the end of the text.
std::size_t lineStartAfter(const NcEditor& editor, std::size_t position) {
    const long line = editor.SendScintilla(QsciScintilla::SCI_LINEFROMPOSITION,
                                           static_cast<unsigned long>(std::min(position, sizeOf(editor))));
    const long next =
        editor.SendScintilla(QsciScintilla::SCI_POSITIONFROMLINE, static_cast<unsigned long>(line + 1));
    return next < 0 ? sizeOf(editor) : static_cast<std::size_t>(next);
}

} // namespace

EditorSearch::EditorSearch(NcEditor& editor, QObject* parent)
    : QObject(parent), m_editor(editor), m_counter([&editor] { return editor.textBytes(); }, this) {
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestMs);
    connect(&m_rest, &QTimer::timeout, this, &EditorSearch::recount);
    connect(&m_counter, &MatchCounter::progressed, this, &EditorSearch::tallied);
    connect(&editor, &QsciScintilla::textChanged, this, [this] {
        if (m_counting)
            m_rest.start();
    });
    connect(&editor, &QsciScintilla::selectionChanged, this, [this] {
        if (m_counting)
            emit tallied();
    });
}

TextPattern EditorSearch::pattern() const {
    return {m_editor.encoded(m_text), m_wholeWords};
}

void EditorSearch::setPattern(const QString& text, bool wholeWords) {
    m_text = text;
    m_wholeWords = wholeWords;
    recount();
}

void EditorSearch::setCounting(bool on) {
    m_counting = on;
    recount();
}

void EditorSearch::recount() {
    m_rest.stop();
    m_counter.count(m_counting ? pattern() : TextPattern());
}

MatchTally EditorSearch::tally() const {
    MatchTally tally{0, m_counter.matches().size(), m_rest.isActive() || !m_counter.done(), m_counter.more()};
    const auto [begin, end] = m_editor.selectedBytes();
    const auto found = std::ranges::lower_bound(m_counter.matches(), begin);
    if (found != m_counter.matches().end() && *found == begin && end - begin == pattern().bytes.size())
        tally.at = static_cast<std::size_t>(found - m_counter.matches().begin()) + 1;
    return tally;
}

bool EditorSearch::find(bool forward) {
    const TextPattern wanted = pattern();
    const std::string_view text = m_editor.textBytes();
    const auto [begin, end] = m_editor.selectedBytes();
    auto match = forward ? findForward(text, wanted, end) : findBackward(text, wanted, begin);
    if (!match)
        match = forward ? findForward(text, wanted, 0) : findBackward(text, wanted, text.size());
    if (match)
        m_editor.selectBytes(*match, *match + wanted.bytes.size());
    return match.has_value();
}

void EditorSearch::replaceSelected(const QString& replacement) {
    const TextPattern wanted = pattern();
    const auto [begin, end] = m_editor.selectedBytes();
    if (end - begin != wanted.bytes.size() || !matchesAt(m_editor.textBytes(), wanted, begin))
        return;
    const std::string instead = m_editor.encoded(replacement);
    m_editor.replaceBytes(begin, end, instead);
    m_editor.selectBytes(begin + instead.size(), begin + instead.size());
}

/// As one edit: otherwise the session would be notified of each match.
int EditorSearch::replacePart(std::size_t begin, std::size_t& end, const TextPattern& wanted,
                              const std::string& instead) {
    const std::string_view text = bytesOf(m_editor, begin, end);
    const auto first = findForward(text, wanted, 0);
    if (!first)
        return 0;
    std::string changed;
    int count = 0;
    std::size_t done = *first;
    for (auto match = first; match; match = findForward(text, wanted, done)) {
        changed.append(text, done, *match - done).append(instead);
        done = *match + wanted.bytes.size();
        ++count;
    }
    m_editor.replaceBytes(begin + *first, begin + done, changed);
    end = end - (done - *first) + changed.size();
    return count;
}

int EditorSearch::replaceAll(const QString& replacement, const Proceed& proceed) {
    const TextPattern wanted = pattern();
    if (m_editor.isReadOnly() || wanted.bytes.empty())
        return 0;
    const std::string instead = m_editor.encoded(replacement);
    OneUndoStep step(m_editor);
    int count = 0;
    for (std::size_t at = 0; at < sizeOf(m_editor);) {
        // A part ends with a line, so no match continues in the next one.
        std::size_t end = lineStartAfter(m_editor, at + kPart);
        count += replacePart(at, end, wanted, instead);
        at = end;
        const std::size_t size = sizeOf(m_editor);
        const bool isWanted =
            at >= size || !proceed || proceed(static_cast<double>(at) / static_cast<double>(size));
        if (step.isGone())
            return 0;
        if (!isWanted) {
            if (count > 0)
                step.revert();
            return 0;
        }
    }
    return count;
}

} // namespace proveout
