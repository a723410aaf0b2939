// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/time/velocity_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace proveout {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Pieces whose directions differ by less form one straight side: 1 - cos of a microradian.
constexpr double kStraight = 1e-12;
constexpr std::size_t kPiecesAtOnce = 16384;

double squared(double value) {
    return value * value;
}

/// Seconds for a piece with these entry and exit speeds, both squared.
double secondsOf(double length, double acceleration, double topSquared, double entry, double exit) {
    const double peakSquared = std::min(topSquared, (entry + exit) / 2 + acceleration * length);
    const double peak = std::sqrt(peakSquared);
    const double gained = std::max(0.0, peak - std::sqrt(entry));
    const double lost = std::max(0.0, peak - std::sqrt(exit));
    const double ramps = (2 * peakSquared - entry - exit) / (2 * acceleration);
    return (gained + lost) / acceleration + std::max(0.0, length - ramps) / peak;
}

} // namespace

VelocityPlan::VelocityPlan(double cornerDeviation, Reported reported)
    : m_cornerDeviation(cornerDeviation), m_reported(std::move(reported)), m_watch(kPiecesAtOnce) {}

/// Squared; from the junction deviation alone, because the length of the following side is not known yet.
double VelocityPlan::cornerLimit(const PathPiece& before, const PathPiece& after) const {
    const double top = squared(std::min(before.topSpeed, after.topSpeed));
    const double cosine = glm::dot(before.endDirection, after.startDirection); // of the change of direction
    if (1 - cosine < kStraight)
        return top;
    const double halfSine = std::sqrt(std::max(0.0, (1 + cosine) / 2)); // of half the angle of the corner
    const double acceleration = std::min(before.acceleration, after.acceleration);
    return std::min(top, acceleration * m_cornerDeviation * halfSine / (1 - halfSine));
}

void VelocityPlan::add(const PathPiece& piece) {
    double limit = 0;
    bool sameSide = false;
    if (!m_pieces.empty()) {
        limit = cornerLimit(m_last, piece);
        const double cosine = glm::dot(m_last.endDirection, piece.startDirection);
        sameSide = m_last.straight && piece.straight && 1 - cosine < kStraight;
        if (!sameSide) {
            closeSide();
            m_sideBefore = m_sideLength;
            m_sideLength = 0;
            m_side = m_pieces.size();
            m_sideCorner =
                1 - cosine < kStraight ? kInfinity : std::sqrt(std::max(0.0, 1 + cosine) / (1 - cosine));
            m_sideAcceleration = std::min(m_last.acceleration, piece.acceleration);
        }
    }
    m_sideLength += piece.length;
    m_pieces.push_back({piece.length, squared(piece.topSpeed), piece.acceleration, limit, piece.owner});
    m_last = piece;
    if (m_pieces.size() >= m_watch && !sameSide)
        reportWhatIsSure();
}

/// The side has its full length now, so the limit at its first corner can be computed.
void VelocityPlan::closeSide() {
    if (m_side == 0 || std::isinf(m_sideCorner))
        return;
    double& limit = m_pieces[m_side].entryLimit;
    limit = std::min(limit, m_sideAcceleration * std::min(m_sideBefore, m_sideLength) / 2 * m_sideCorner);
}

/// The largest entry speeds from which braking for everything that follows is still possible.
void VelocityPlan::planBackward() {
    m_entry.assign(m_pieces.size() + 1, 0);
    for (std::size_t i = m_pieces.size(); i-- > 0;)
        m_entry[i] = std::min(m_pieces[i].entryLimit,
                              m_entry[i + 1] + 2 * m_pieces[i].acceleration * m_pieces[i].length);
}

/// Reports the times of the first pieces, whose entry speeds are planned, and removes them.
void VelocityPlan::report(std::size_t count) {
    double entry = m_pieces.empty() ? 0 : m_entry[0];
    for (std::size_t i = 0; i < count; ++i) {
        const Planned& piece = m_pieces[i];
        const double exit = std::min(m_entry[i + 1], entry + 2 * piece.acceleration * piece.length);
        m_reported(piece.owner, secondsOf(piece.length, piece.acceleration, piece.topSquared, entry, exit));
        entry = exit;
    }
    m_pieces.erase(m_pieces.begin(), m_pieces.begin() + static_cast<std::ptrdiff_t>(count));
    if (!m_pieces.empty())
        m_pieces.front().entryLimit = entry;
}

/// Where a piece may be entered at its limit even if the machine had to stop at the very last corner, nothing
/// that follows can change the times of earlier pieces.
void VelocityPlan::reportWhatIsSure() {
    const double open = std::exchange(m_pieces[m_side].entryLimit, 0); // its side may still grow
    planBackward();
    m_pieces[m_side].entryLimit = open;
    std::size_t sure = m_side;
    while (sure > 0 && m_entry[sure - 1] < m_pieces[sure - 1].entryLimit)
        --sure;
    sure -= sure > 0 ? 1 : 0;
    if (sure > 0) {
        report(sure);
        m_side -= sure;
    }
    m_watch = std::max(kPiecesAtOnce, 2 * m_pieces.size());
}

void VelocityPlan::stop() {
    if (m_pieces.empty())
        return;
    closeSide();
    planBackward();
    report(m_pieces.size());
    m_side = 0;
    m_sideLength = 0;
    m_watch = kPiecesAtOnce;
}

} // namespace proveout
