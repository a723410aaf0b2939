// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/certified/certified_border.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "core/decimation/lattice/lattice_scan.h"

namespace proveout {

namespace {

/// Sums over the samples before one sample, from which the squared distances to any chord follow at once.
struct Sums {
    double z = 0;
    double kz = 0;
    double zz = 0;
};

class ShortestPath {
public:
    ShortestPath(std::span<const float> heights, double limit, std::span<const std::uint32_t> extras)
        : m_count(heights.size()), m_limit(limit), m_samples(heights.size()) {
        Sums sums;
        for (std::size_t k = 0; k < m_count; ++k) {
            // Relative to the first sample, so that the sums do not cancel.
            const double z = double{heights[k]} - double{heights[0]};
            m_samples[k].z = z;
            m_samples[k].inverse = 1 / static_cast<double>(k);
            m_samples[k].before = sums;
            sums.z += z;
            sums.kz += static_cast<double>(k) * z;
            sums.zz += z * z;
        }
        m_chords.reserve(16 * m_count);
        findChords(extras);
        chooseChords();
    }

    [[nodiscard]] BorderLine path() const {
        BorderLine line;
        line.kept.reserve(m_samples[0].chordsToEnd + 1);
        for (std::size_t k = 0; k + 1 < m_count; k = m_samples[k].next)
            line.kept.push_back(static_cast<std::uint32_t>(k));
        line.kept.push_back(static_cast<std::uint32_t>(m_count - 1));
        return line;
    }

private:
    struct Sample {
        double z = 0;
        double inverse = 0; ///< 1 / k
        Sums before;
        double cost = 0; ///< of the best path from here to the end
        std::uint32_t chordsToEnd = 0;
        std::uint32_t chordsFromBegin = std::numeric_limits<std::uint32_t>::max();
        std::uint32_t firstChord = 0; ///< index in m_chords
        std::uint32_t next = 0;
    };

    /// Finds all chords that stay within the limit, by their first sample; no chord passes over one of the
    /// extras.
    void findChords(std::span<const std::uint32_t> extras) {
        m_samples[0].chordsFromBegin = 0;
        auto extra = extras.begin();
        for (std::size_t from = 0; from + 1 < m_count; ++from) {
            while (extra != extras.end() && *extra <= from)
                ++extra;
            const std::size_t last = extra == extras.end() ? m_count - 1 : *extra;
            Sample& sample = m_samples[from];
            sample.firstChord = static_cast<std::uint32_t>(m_chords.size());
            double low = -std::numeric_limits<double>::infinity();
            double high = std::numeric_limits<double>::infinity();
            for (std::size_t to = from + 1; to <= last && low <= high; ++to) {
                const double inverse = m_samples[to - from].inverse;
                const double slope = (m_samples[to].z - sample.z) * inverse;
                if (slope >= low && slope <= high) {
                    m_chords.push_back(static_cast<std::uint32_t>(to));
                    m_samples[to].chordsFromBegin =
                        std::min(m_samples[to].chordsFromBegin, sample.chordsFromBegin + 1);
                }
                low = std::max(low, slope - m_limit * inverse);
                high = std::min(high, slope + m_limit * inverse);
            }
        }
        m_samples[m_count - 1].firstChord = static_cast<std::uint32_t>(m_chords.size());
    }

    /// Chooses from the end: the fewest chords, and of these paths the one nearest to the samples. Costs are
    /// computed only where a path with the fewest chords from the beginning may pass.
    void chooseChords() {
        const std::uint32_t fewest = m_samples[m_count - 1].chordsFromBegin;
        for (std::size_t from = m_count - 1; from-- > 0;) {
            Sample& sample = m_samples[from];
            sample.chordsToEnd = std::numeric_limits<std::uint32_t>::max() / 2;
            for (std::uint32_t at = sample.firstChord; at < m_samples[from + 1].firstChord; ++at) {
                const Sample& end = m_samples[m_chords[at]];
                const std::uint32_t chords = end.chordsToEnd + 1;
                if (sample.chordsFromBegin + chords > fewest)
                    continue;
                const double cost = end.cost + squaredDistances(from, m_chords[at]);
                if (chords < sample.chordsToEnd || cost < sample.cost) {
                    sample.chordsToEnd = chords;
                    sample.cost = cost;
                    sample.next = m_chords[at];
                }
            }
        }
    }

    /// The sum of squared distances of the samples between two samples from their chord; it only decides
    /// between equal paths, so rounding does not matter.
    [[nodiscard]] double squaredDistances(std::size_t from, std::size_t to) const {
        const Sample& a = m_samples[from];
        const Sample& b = m_samples[to];
        const double first = static_cast<double>(from);
        const double n = static_cast<double>(to - from);
        const double slope = (b.z - a.z) * m_samples[to - from].inverse;
        const double offset = a.z - slope * first; // z = offset + slope k
        const double k = n * first + n * (n - 1) / 2;
        const double kk = n * first * first + first * n * (n - 1) + n * (n - 1) * (2 * n - 1) / 6;
        return b.before.zz - a.before.zz - 2 * offset * (b.before.z - a.before.z) -
               2 * slope * (b.before.kz - a.before.kz) + n * offset * offset + 2 * offset * slope * k +
               slope * slope * kk;
    }

    std::size_t m_count;
    double m_limit;
    std::vector<Sample> m_samples;
    std::vector<std::uint32_t> m_chords; ///< last samples
};

bool chordHolds(std::span<const float> heights, double limit) {
    const double z = double{heights.front()};
    const double slope = (double{heights.back()} - z) / static_cast<double>(heights.size() - 1);
    bool holds = true;
    for (std::size_t k = 1; k + 1 < heights.size(); ++k)
        holds &= std::abs(double{heights[k]} - (z + slope * static_cast<double>(k))) <= limit;
    return holds;
}

} // namespace

BorderLine certifiedBorder(std::span<const float> heights, double allowance,
                           std::span<const std::uint32_t> kept) {
    const double limit = allowance - roundingGuard(heights);
    // The middle of two cells is next to both corners; see snapToKept().
    if (heights.size() <= 3 || limit <= 0) {
        BorderLine line;
        line.kept.resize(heights.size());
        std::iota(line.kept.begin(), line.kept.end(), 0U);
        return line;
    }
    if (kept.empty() && chordHolds(heights, limit))
        return {{0, static_cast<std::uint32_t>(heights.size() - 1)}, {}};
    return ShortestPath(heights, limit, kept).path();
}

} // namespace proveout
