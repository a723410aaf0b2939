// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <QObject>
#include <QString>

#include "ui/editor/match_counter.h"
#include "ui/editor/text_search.h"

namespace proveout {

class NcEditor;

/// The number of matches, and which of them is selected. Value type.
struct MatchTally {
    std::size_t at = 0; ///< 1-based; 0: none of the counted matches is selected
    std::size_t total = 0;
    bool counting = false; ///< the count is not finished
    bool more = false;     ///< there are more matches than are counted

    friend bool operator==(const MatchTally&, const MatchTally&) = default;
};

/// Finds and replaces a pattern in the text of an editor. Thread: UI.
class EditorSearch final : public QObject {
    Q_OBJECT

public:
    /// `editor` must outlive this object.
    EditorSearch(NcEditor& editor, QObject* parent);

    void setPattern(const QString& text, bool wholeWords);
    /// Matches are counted only while the tally is shown.
    void setCounting(bool on);
    [[nodiscard]] MatchTally tally() const;

    /// Selects the next match after the selection (or the last one before it), wrapping around at the end.
    /// False: there is no match.
    bool find(bool forward);
    /// Replaces the selection if it is a match.
    void replaceSelected(const QString& replacement);
    /// Replaces all matches as one undo step; returns their number.
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
    QTimer m_rest; ///< counts when the user has stopped typing for a moment
    MatchCounter m_counter;
};

} // namespace proveout
