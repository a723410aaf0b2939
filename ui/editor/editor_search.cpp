// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editor/editor_search.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "ui/editor/nc_editor.h"

namespace proveout {

namespace {
constexpr int kRestMs = 120;
}

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

int EditorSearch::replaceAll(const QString& replacement) {
    const TextPattern wanted = pattern();
    const std::string_view text = m_editor.textBytes();
    const auto first = findForward(text, wanted, 0);
    if (!first || m_editor.isReadOnly())
        return 0;
    // As one edit: otherwise the session would be notified of thousands of single edits.
    const std::string instead = m_editor.encoded(replacement);
    std::string changed;
    int count = 0;
    std::size_t end = *first;
    for (auto match = first; match; match = findForward(text, wanted, end)) {
        changed.append(text, end, *match - end).append(instead);
        end = *match + wanted.bytes.size();
        ++count;
    }
    m_editor.replaceBytes(*first, end, changed);
    return count;
}

} // namespace proveout
