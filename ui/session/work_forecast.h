// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace proveout {

/// How long an operation will still take, from its progress so far. Value type; the clock is the caller's.
class WorkForecast {
public:
    /// The progress, in [0, 1], at a time in seconds. Progress that falls begins another operation.
    void follow(double done, double seconds);
    /// The operation has ended.
    void end() { *this = {}; }

    /// Seconds, rounded as they are known: to 5 below a minute, else to 30. Nothing until enough is done to
    /// tell, and for operations that are about to end.
    [[nodiscard]] std::optional<int> secondsLeft() const { return m_left; }

private:
    std::optional<double> m_begin; ///< seconds
    double m_first = 0;            ///< progress then
    double m_done = 0;
    std::optional<int> m_left;
};

} // namespace proveout
