// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/records/activity_log.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace proveout {

Activity activityOf(const Program& program, std::size_t block, const BlockStatistics& row) {
    const auto motions = program.blockMotions(block);
    bool rapid = true;
    for (std::size_t index = motions.first; rapid && index < motions.last; ++index)
        rapid = program.motion(index).kind == MotionKind::rapid;
    if (rapid)
        return row.cuts() ? Activity::rapidInStock : Activity::rapid;
    return row.cuts() ? Activity::cutting : Activity::air;
}

double ActivitySums::share(Activity activity) const {
    const auto index = static_cast<std::size_t>(activity);
    const double whole = std::accumulate(seconds.begin(), seconds.end(), 0.0);
    if (whole > 0)
        return seconds[index] / whole;
    const auto count = std::accumulate(blocks.begin(), blocks.end(), std::uint64_t{0});
    return count > 0 ? static_cast<double>(blocks[index]) / static_cast<double>(count) : 0;
}

void ActivityLog::clear() {
    ++m_revision;
    m_activities.clear();
    m_stations.clear();
    m_total = {};
}

void ActivityLog::append(const Program& program, const PersistentArray<BlockStatistics>& rows,
                         std::size_t end) {
    end = std::min({end, rows.size(), program.blockCount()});
    for (std::size_t block = size(); block < end; ++block) {
        m_activities.push_back(activityOf(program, block, rows[block]));
        countNext(block);
    }
}

void ActivityLog::setTimes(std::shared_ptr<const MachineTimes> times) {
    if (times == m_times)
        return;
    m_times = std::move(times);
    ++m_revision;
    m_stations.clear();
    m_total = {};
    for (std::size_t block = 0; block < size(); ++block)
        countNext(block);
}

void ActivityLog::count(ActivitySums& sums, std::size_t block) const {
    const auto index = static_cast<std::size_t>(m_activities[block]);
    ++sums.blocks[index];
    if (m_times && block + 1 < m_times->secondsAfter.size())
        sums.seconds[index] += m_times->movingSeconds(block);
}

void ActivityLog::countNext(std::size_t block) {
    if (block % kStep == 0)
        m_stations.push_back(m_total);
    count(m_total, block);
}

/// Adds in the order of the blocks, starting from any station, so that a stretch without time has a sum of
/// exactly zero.
ActivitySums ActivityLog::sumsBefore(std::size_t block) const {
    if (block == size())
        return m_total;
    ActivitySums sums = m_stations[block / kStep];
    for (std::size_t each = block / kStep * kStep; each < block; ++each)
        count(sums, each);
    return sums;
}

ActivitySums ActivityLog::sums(std::size_t first, std::size_t last) const {
    last = std::min(last, size());
    if (first >= last)
        return {};
    const ActivitySums before = sumsBefore(first);
    ActivitySums sums = sumsBefore(last);
    for (std::size_t index = 0; index < kActivities; ++index) {
        sums.seconds[index] -= before.seconds[index];
        sums.blocks[index] -= before.blocks[index];
    }
    return sums;
}

} // namespace proveout
