// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/work_forecast.h"

#include <cmath>

namespace proveout {

namespace {

constexpr double kLeastSeconds = 2; ///< of which a forecast is made, and for which it is worth reading
constexpr double kLeastDone = 0.02;
constexpr double kMinute = 60;
constexpr int kStepBelowMinute = 5;
constexpr int kStepAbove = 30;

int rounded(double seconds) {
    const int step = seconds < kMinute ? kStepBelowMinute : kStepAbove;
    return step * static_cast<int>(std::ceil(seconds / step));
}

} // namespace

void WorkForecast::follow(double done, double seconds) {
    if (!m_begin || done < m_done) {
        m_begin = seconds;
        m_first = done;
    }
    m_done = done;
    m_left.reset();
    const double elapsed = seconds - *m_begin;
    const double since = done - m_first;
    if (elapsed < kLeastSeconds || since < kLeastDone)
        return;
    const double left = elapsed * (1 - done) / since;
    constexpr double kUnbelievable = 100 * 3600.0;
    if (left >= kLeastSeconds && left < kUnbelievable)
        m_left = rounded(left);
}

} // namespace proveout
