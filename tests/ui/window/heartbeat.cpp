// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window/heartbeat.h"

#include <ctime>

namespace proveout {

namespace {

constexpr int kBeatMs = 5;

} // namespace

double threadCpuMs() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

Heartbeat::Heartbeat() {
    QObject::connect(&m_timer, &QTimer::timeout, [this] { beat(); });
    begin();
    m_timer.start(kBeatMs);
}

void Heartbeat::stop() {
    beat();
    m_timer.stop();
}

void Heartbeat::beat() {
    m_gaps.push_back(1e-6 * static_cast<double>(m_clock.nsecsElapsed()));
    m_computed.push_back(threadCpuMs() - m_cpuMs);
    begin();
}

void Heartbeat::begin() {
    m_clock.start();
    m_cpuMs = threadCpuMs();
}

} // namespace proveout
