// SPDX-License-Identifier: GPL-3.0-or-later
// How long the event loop of this thread does not go round.
#pragma once

#include <vector>

#include <QElapsedTimer>
#include <QTimer>

namespace proveout {

/// The gaps between the beats of a timer: how long each took, and how much of it the thread itself computed;
/// what other processes take of the machine stretches the first only. From its construction to stop(). ms.
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

/// Of the processor, of this thread.
[[nodiscard]] double threadCpuMs();

} // namespace proveout
