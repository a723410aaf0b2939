// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "core/decimation/regions/parameters.h"

namespace proveout {

/// When the dirty regions are decimated (paper §3, step 4): after every s-th executed motion block. The
/// schedule is logical: it depends on block counts and not on a clock. Value type.
class Schedule {
public:
    explicit Schedule(const DecimationParameters& parameters)
        : m_period(decimates(parameters) ? parameters.period : 0) {}

    /// One that never decimates anything.
    [[nodiscard]] static Schedule never() { return Schedule(DecimationParameters{.period = 0}); }

    /// Whether anything is ever decimated with these parameters.
    [[nodiscard]] bool decimates() const { return m_period != 0; }
    /// Whether regions are decimated again after they have been cut.
    [[nodiscard]] bool repeats() const { return m_period > 0; }
    /// Whether the dirty regions are decimated when `block` blocks have been executed.
    [[nodiscard]] bool isMoment(std::size_t block) const { return lastMoment(block) == block; }
    /// The newest such moment at or before `block`; nothing if nothing is decimated.
    [[nodiscard]] std::optional<std::size_t> lastMoment(std::size_t block) const {
        if (m_period == 0)
            return std::nullopt;
        if (m_period < 0)
            return 0;
        return block - block % static_cast<std::size_t>(m_period);
    }

private:
    static bool decimates(const DecimationParameters& parameters) {
        return parameters.method != DecimationMethod::none && parameters.allowance > 0;
    }

    int m_period; ///< 0: never, negative: once at the start
};

} // namespace proveout
