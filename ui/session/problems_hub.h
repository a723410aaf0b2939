// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <QObject>

#include "core/base/diagnostic.h"

namespace proveout {

/// The sources of problems, listed in this sequence.
enum class ProblemSource : std::uint8_t {
    files,      ///< files, jobs, exports, and requests that failed
    stockFile,  ///< the stock file, until the problem is resolved
    simulation, ///< the last load
    program,    ///< the newest interpretation
    findings,   ///< of the newest frame
};

/// The problems from all sources in one list. Thread: the UI thread.
class ProblemsHub final : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    [[nodiscard]] const Diagnostics& all() const { return m_all; }
    [[nodiscard]] const Diagnostics& of(ProblemSource source) const {
        return m_bySource.at(static_cast<std::size_t>(source));
    }
    /// Whether the location of a problem is in the open text; other problems name their file (e.g. a job
    /// file).
    [[nodiscard]] static bool isInText(const Diagnostic& problem);

    /// Replaces the messages that do not concern the program, e.g. about a dropped file that cannot be used.
    void report(const Diagnostics& messages);
    /// Adds to these messages.
    void add(const Diagnostics& messages);
    /// Replaces the problems of one source; refresh() shows them.
    void set(ProblemSource source, Diagnostics problems);
    void refresh();

signals:
    void changed();
    /// A request has failed; the reason is in all().
    void troubled();

private:
    std::array<Diagnostics, 5> m_bySource;
    Diagnostics m_all;
};

} // namespace proveout
