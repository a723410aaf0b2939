// SPDX-License-Identifier: GPL-3.0-or-later
// Measures how long the event loop of this thread is blocked.
#pragma once

#include <vector>

#include <QElapsedTimer>
#include <QTimer>

namespace proveout {

/// The gaps between the beats of a timer: the duration of each, and the CPU time of the thread in it; other
/// processes lengthen only the duration. From construction to stop(). ms.
class Heartbeat {
public:
    Heartbeat();
    void stop();
    [[nodiscard]] const std::vector<double>& gaps() const { return m_gaps; }
    [[nodiscard]] const std::vector<double>& computed() const { return m_computed; }

private:
    void beat();
    void begin();

    QTimer m_timer;
    QElapsedTimer m_clock;
    double m_cpuMs = 0;
    std::vector<double> m_gaps;
    std::vector<double> m_computed;
};

/// CPU time of this thread.
[[nodiscard]] double threadCpuMs();

} // namespace proveout
