// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <QObject>
#include <QString>

#include "ui/editor/match_counter.h"
#include "ui/editor/text_search.h"

namespace proveout {

class NcEditor;

/// How many matches there are, and which of them is selected. Value type.
struct MatchTally {
    std::size_t at = 0; ///< 1-based; 0: none of those counted
    std::size_t total = 0;
    bool counting = false; ///< more may come
    bool more = false;     ///< there are more than are counted

    friend bool operator==(const MatchTally&, const MatchTally&) = default;
};

/// Finds and replaces a pattern in the text of an editor. Thread: UI.
class EditorSearch final : public QObject {
    Q_OBJECT

public:
    /// `editor` outlives this object.
    EditorSearch(NcEditor& editor, QObject* parent);

    void setPattern(const QString& text, bool wholeWords);
    /// Matches are counted while somebody looks at the tally.
    void setCounting(bool on);
    [[nodiscard]] MatchTally tally() const;

    /// Selects the next match after (or the last one before) the selection, round the end. False: there is
    /// none.
    bool find(bool forward);
    /// Replaces the selection where it is a match.
    void replaceSelected(const QString& replacement);
    /// Replaces all matches as one step of undo; tells how many there were.
    int replaceAll(const QString& replacement);

signals:
    void tallied();

private:
    [[nodiscard]] TextPattern pattern() const;
    void recount();

    NcEditor& m_editor;
    QString m_text;
    bool m_wholeWords = false;
    bool m_counting = false;
    QTimer m_rest; ///< typing is counted after a short rest
    MatchCounter m_counter;
};

} // namespace proveout
