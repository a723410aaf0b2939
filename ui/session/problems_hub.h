// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <QObject>

#include "core/base/diagnostic.h"

namespace proveout {

/// Where problems come from; they are listed in this order.
enum class ProblemSource : std::uint8_t {
    files,      ///< files and jobs, exports, what was asked for and could not be done
    stockFile,  ///< the file of the stock, as long as it holds
    simulation, ///< the last load
    program,    ///< the newest interpretation
    findings,   ///< of the newest frame
};

/// What is wrong, from every source, as one list. Thread: the UI thread.
class ProblemsHub final : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    [[nodiscard]] const Diagnostics& all() const { return m_all; }
    /// Whether the place of a problem is one of the open text; others name their file (a job file, say).
    [[nodiscard]] static bool isInText(const Diagnostic& problem);

    /// Shows messages that are about no part of the program, e.g. a dropped file that cannot be used, in
    /// place of those before.
    void report(const Diagnostics& messages);
    /// Shows them with those before.
    void add(const Diagnostics& messages);
    /// Replaces the problems of one source; shown by the next refresh().
    void set(ProblemSource source, Diagnostics problems);
    void refresh();

signals:
    void changed();
    /// What was asked for could not be done; the reason is in all().
    void troubled();

private:
    std::array<Diagnostics, 5> m_bySource;
    Diagnostics m_all;
};

} // namespace proveout
