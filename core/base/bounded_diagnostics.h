// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/base/diagnostic.h"
#include "core/base/finding_row.h"

namespace proveout {

/// Keeps the first messages about an input and counts the rest: a file of a wrong kind must not flood the
/// reader or the memory. Owned by one thread.
class BoundedDiagnostics {
public:
    static constexpr std::size_t kMost = 100;

    [[nodiscard]] bool empty() const { return m_first.empty(); }
    /// Whether further messages are only counted.
    [[nodiscard]] bool full() const { return m_first.size() == kMost; }

    void add(Diagnostic diagnostic);
    /// Counts messages that are not made in the first place.
    void omit(Severity severity, bool unverified, std::size_t count);
    /// Sorts the messages by their place in the text.
    void sortByPlace();
    /// Appends the messages of `others`.
    void append(BoundedDiagnostics others);

    /// The messages; if there were more, a last one gives their number and is as severe as the worst of them.
    /// The text of `more` has one `{}`, for the number. This object is empty afterwards.
    [[nodiscard]] Diagnostics take(const FindingRow& more);
    /// With the row for messages about a file.
    [[nodiscard]] Diagnostics take();

private:
    Diagnostics m_first;
    std::size_t m_left = 0;
    Severity m_worst = Severity::note; ///< of the messages that were only counted
    bool m_unverified = false;         ///< any of the messages that were only counted
};

} // namespace proveout
