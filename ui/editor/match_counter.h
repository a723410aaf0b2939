// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "ui/editor/text_search.h"

namespace proveout {

/// Finds all matches of a pattern in slices, between the events of the window. Thread: UI.
class MatchCounter final : public QObject {
    Q_OBJECT

public:
    static constexpr std::size_t kMost = 1'000'000; ///< matches; the search stops there
    /// Returns the text at the moment of the call.
    using Text = std::function<std::string_view()>;

    MatchCounter(Text text, QObject* parent);
    /// Starts the count again; call it after each change of the text too. An empty pattern has no matches.
    void count(const TextPattern& pattern);

    /// Start offsets of the matches found until now, ascending; matches do not overlap.
    [[nodiscard]] const std::vector<std::size_t>& matches() const { return m_matches; }
    [[nodiscard]] bool done() const { return !m_timer.isActive(); }
    /// Whether there are more than kMost matches.
    [[nodiscard]] bool more() const { return m_more; }

signals:
    /// More matches were found, or the search has ended.
    void progressed();

private:
    void countPart();

    Text m_text;
    TextPattern m_pattern;
    std::size_t m_from = 0;
    std::vector<std::size_t> m_matches;
    bool m_more = false;
    QTimer m_timer;
    QElapsedTimer m_sinceReported;
};

} // namespace proveout
