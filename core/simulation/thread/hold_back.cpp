// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/thread/hold_back.h"

#include <algorithm>
#include <utility>

namespace proveout {

namespace {

/// With so few faces in total, drawing them costs less than checking whether it could be cheaper.
constexpr std::size_t kFewFaces = 2048;
constexpr std::size_t kLeastWindow = 8;
constexpr std::size_t kLongestWindow = 64;
/// One window per this many frames: trials stay below the 99th percentile.
constexpr std::size_t kFirstInterval = 100;
constexpr std::size_t kLongestInterval = 1u << 20;
/// The share that a trial may cost of the time played since the last trial.
constexpr double kAffordable = 0.01;
/// The other mode must be cheaper by this share to be chosen; otherwise the two would alternate forever.
constexpr double kMargin = 0.05;
/// Faces decimated per second before it is measured: the value of a slow machine.
constexpr double kAssumedFacesPerSecond = 1e6;

std::size_t windowFrames(int period) {
    return std::clamp(2 * static_cast<std::size_t>(std::max(period, 0)), kLeastWindow, kLongestWindow);
}

} // namespace

HoldBack::HoldBack(int period, std::size_t facesFull)
    : m_windowFrames(windowFrames(period)), m_held(facesFull <= kFewFaces),
      m_interval(kFirstInterval * m_windowFrames) {}

bool HoldBack::add(const FrameCost& cost) {
    if (cost.drawSeconds <= 0)
        return false;
    m_secondsSince += cost.total();
    ++m_framesSince;
    if (m_turning) {
        m_turning = false;
        return false;
    }
    FrameCost& sum = m_window.sum;
    sum.decimationSeconds += cost.decimationSeconds;
    sum.uploadSeconds += cost.uploadSeconds;
    sum.drawSeconds += cost.drawSeconds;
    sum.facesShown += cost.facesShown;
    sum.facesFull += cost.facesFull;
    sum.regionsDecimated += cost.regionsDecimated;
    if (sum.regionsDecimated > 0)
        m_secondsPerRegion = sum.decimationSeconds / static_cast<double>(sum.regionsDecimated);
    m_wholeSeconds = m_secondsPerRegion > 0 ? m_secondsPerRegion * static_cast<double>(cost.regions)
                                            : static_cast<double>(cost.facesFull) / kAssumedFacesPerSecond;
    if (++m_window.frames < m_windowFrames)
        return false;
    const bool before = m_held;
    if (closeWindow())
        turn();
    m_window = {};
    return m_held != before;
}

/// Returns whether to switch to the other mode.
bool HoldBack::closeWindow() {
    m_means[m_held ? 1 : 0] = m_window.sum.total() / static_cast<double>(m_window.frames);
    const bool challenger = std::exchange(m_trial, false);
    if (challenger && cheaperThan(!m_held)) {
        m_interval = kFirstInterval * m_windowFrames;
        return false;
    }
    if (challenger) {
        m_interval = std::min(2 * m_interval, kLongestInterval);
        return true;
    }
    if (!m_held && cannotPay()) {
        const double frames = static_cast<double>(m_window.frames);
        const FrameCost& sum = m_window.sum;
        m_means[1] = (sum.uploadSeconds + sum.drawSeconds * static_cast<double>(sum.facesFull) /
                                              static_cast<double>(sum.facesShown)) /
                     frames;
        return true;
    }
    m_trial = isTrialDue();
    return m_trial;
}

/// Even if drawing had no cost besides its triangles, decimation would take longer than it saves.
bool HoldBack::cannotPay() const {
    const FrameCost& sum = m_window.sum;
    if (sum.facesShown == 0)
        return false;
    const double secondsPerFace = sum.drawSeconds / static_cast<double>(sum.facesShown);
    return sum.decimationSeconds > secondsPerFace * static_cast<double>(sum.facesFull - sum.facesShown);
}

/// Whether the present mode is clearly cheaper than the other one.
bool HoldBack::cheaperThan(bool other) const {
    const auto& mine = m_means[m_held ? 1 : 0];
    const auto& others = m_means[other ? 1 : 0];
    return !others || *mine < (1 - kMargin) * *others;
}

/// Either switching to the other mode or switching back decimates the whole map once.
bool HoldBack::isTrialDue() const {
    const double mine = m_means[m_held ? 1 : 0].value_or(0);
    const double others = m_means[m_held ? 0 : 1].value_or(mine);
    const double price = m_wholeSeconds + static_cast<double>(m_windowFrames) * std::max(0.0, others - mine);
    // Drawing everything is tried as soon as it is affordable; a tiny map that never tries it loses little.
    const std::size_t interval = m_held || m_means[1] ? m_interval : m_windowFrames;
    return m_framesSince >= interval && price <= kAffordable * m_secondsSince;
}

void HoldBack::turn() {
    m_held = !m_held;
    m_turning = true;
    m_framesSince = 0;
    m_secondsSince = 0;
}

} // namespace proveout
