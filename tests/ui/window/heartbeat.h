// SPDX-License-Identifier: GPL-3.0-or-later
// How long the event loop of this thread does not go round.
#pragma once

#include <QElapsedTimer>
#include <QTimer>

namespace proveout {

/// The longest gap between two beats of a timer, and the most that the thread itself computed between two:
/// what other processes take of the machine stretches the first only. From its construction to stop().
class Heartbeat {
public:
    Heartbeat();
    void stop();
    [[nodiscard]] double longestMs() const { return m_longestMs; }
    [[nodiscard]] double mostComputedMs() const { return m_mostComputedMs; }

private:
    void beat();
    void begin();

    QTimer m_timer;
    QElapsedTimer m_clock;
    double m_cpuMs = 0;
    double m_longestMs = 0;
    double m_mostComputedMs = 0;
};

} // namespace proveout
