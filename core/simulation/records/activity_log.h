// SPDX-License-Identifier: GPL-3.0-or-later
// What the machine does in any stretch of a program: rapids, feed through air, cutting.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/persistent_array.h"
#include "core/nc/program/program.h"
#include "core/simulation/run/statistics.h"
#include "core/simulation/time/machine_time.h"

namespace proveout {

/// What a block does; it counts as a whole, and as cutting if any of its motions cuts. A rapid through stock
/// is a kind of its own, so that it is visible in every sum.
enum class Activity : std::uint8_t { rapid, air, cutting, rapidInStock };
inline constexpr std::size_t kActivities = 4;
[[nodiscard]] Activity activityOf(const Program& program, std::size_t block, const BlockStatistics& row);

/// The sums of a stretch, by Activity.
struct ActivitySums {
    std::array<double, kActivities> seconds{}; ///< of motion, without dwells and tool changes
    std::array<std::uint32_t, kActivities> blocks{};

    [[nodiscard]] bool has(Activity activity) const { return blocks[static_cast<std::size_t>(activity)] > 0; }
    [[nodiscard]] bool empty() const { return blocks == std::array<std::uint32_t, kActivities>{}; }
    /// Its share of the time, in [0, 1]; its share of the blocks if no time is known or no block takes any.
    [[nodiscard]] double share(Activity activity) const;
};

/// The activities of the executed blocks, growing with them. The sums of a stretch take constant time, so
/// that the cost of a picture of a million blocks depends only on its pixels. About two bytes per block. One
/// thread.
class ActivityLog {
public:
    /// The number of blocks known.
    [[nodiscard]] std::size_t size() const { return m_activities.size(); }
    /// Rises whenever known values change or become unknown.
    [[nodiscard]] std::uint64_t revision() const { return m_revision; }
    void clear();
    /// Appends the blocks from size() on up to `end`, of a program and the rows of its simulation.
    void append(const Program& program, const PersistentArray<BlockStatistics>& rows, std::size_t end);
    /// The times of the program whose blocks are appended; null: unknown. The sums are computed again.
    void setTimes(std::shared_ptr<const MachineTimes> times);
    [[nodiscard]] const std::shared_ptr<const MachineTimes>& times() const { return m_times; }

    /// The sums of the blocks [first, last) as far as they are known.
    [[nodiscard]] ActivitySums sums(std::size_t first, std::size_t last) const;
    [[nodiscard]] const ActivitySums& total() const { return m_total; }

private:
    static constexpr std::size_t kStep = 64;

    void count(ActivitySums& sums, std::size_t block) const;
    void countNext(std::size_t block);
    [[nodiscard]] ActivitySums sumsBefore(std::size_t block) const;

    std::vector<Activity> m_activities;
    std::vector<ActivitySums> m_stations; ///< [k]: of the first k · kStep blocks
    ActivitySums m_total;
    std::shared_ptr<const MachineTimes> m_times;
    std::uint64_t m_revision = 0;
};

} // namespace proveout
