// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>

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
    /// Called between two parts of a long text, with the part that is done, in [0, 1]; it may handle events
    /// that do not change the text. False: stop.
    using Proceed = std::function<bool(double done)>;
    /// Replaces all matches as one undo step; returns their number. If it is stopped, nothing is replaced.
    int replaceAll(const QString& replacement, const Proceed& proceed = {});

signals:
    void tallied();

private:
    [[nodiscard]] TextPattern pattern() const;
    void recount();
    /// Replaces the matches in the lines [begin, end); returns their number, and moves `end` with the text.
    int replacePart(std::size_t begin, std::size_t& end, const TextPattern& wanted,
                    const std::string& instead);

    NcEditor& m_editor;
    QString m_text;
    bool m_wholeWords = false;
    bool m_counting = false;
    QTimer m_rest; ///< counts when the user has stopped typing for a moment
    MatchCounter m_counter;
};

} // namespace proveout
