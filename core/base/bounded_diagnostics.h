// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/base/diagnostic.h"
#include "core/base/finding_row.h"

namespace proveout {

/// The first messages about an input, and how many more there were: a file that is nothing of its kind shall
/// not flood whoever reads them, nor the memory. Owned by one thread.
class BoundedDiagnostics {
public:
    static constexpr std::size_t kMost = 100;

    [[nodiscard]] bool empty() const { return m_first.empty(); }
    /// Whether further ones will only be counted.
    [[nodiscard]] bool full() const { return m_first.size() == kMost; }

    void add(Diagnostic diagnostic);
    /// Counts messages that are not even made.
    void omit(Severity severity, bool unverified, std::size_t count);
    /// In the order of the text.
    void sortByPlace();
    /// Those of `others` behind these.
    void append(BoundedDiagnostics others);

    /// The messages; where there were more, a last one tells how many, and is as severe as the worst of them.
    /// The text of `more` has one `{}`, for the number. This is empty afterwards.
    [[nodiscard]] Diagnostics take(const FindingRow& more);
    /// With the row for messages about a file.
    [[nodiscard]] Diagnostics take();

private:
    Diagnostics m_first;
    std::size_t m_left = 0;
    Severity m_worst = Severity::note; ///< of those left out
    bool m_unverified = false;         ///< any of those left out
};

} // namespace proveout
