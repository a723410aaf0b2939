// SPDX-License-Identifier: GPL-3.0-or-later
// Lowers a block by many passes in the order that leaves the least work. Compiled once per instruction set.
#if defined(PROVEOUT_CUTTING_BLOCK_BY_ALL) == defined(HWY_TARGET_TOGGLE)
#ifdef PROVEOUT_CUTTING_BLOCK_BY_ALL
#undef PROVEOUT_CUTTING_BLOCK_BY_ALL
#else
#define PROVEOUT_CUTTING_BLOCK_BY_ALL
#endif

#include <bit>

#include "core/cutting/kernels/block_kernel-inl.h"

HWY_BEFORE_NAMESPACE();
namespace proveout {
namespace HWY_NAMESPACE {
namespace {

/// Of all passes, those whose bounds are lowest at some places of a block that are far from each other: once
/// these passes are cut, most others are above the surface.
class Seeds {
public:
    static constexpr std::size_t kPlaces = 5;

    Seeds() {
        for (std::size_t k = 0; k < kPlaces; ++k) {
            m_lowest[k] = all(kInfinity);
            m_passes[k] = hn::Zero(kFloats);
        }
    }

    /// `passes`: their indices; only those that `may` lower the block count.
    HWY_INLINE void look(const Planes& planes, M may, V passes) {
        for (std::size_t k = 0; k < kPlaces; ++k) {
            const V ofRow = productPlus(all(kRows[k]), planes.perRow, planes.middle);
            const V z = productPlus(all(kColumns[k]), planes.perColumn, ofRow);
            const M better = hn::And(may, hn::Lt(z, m_lowest[k]));
            m_lowest[k] = hn::IfThenElse(better, z, m_lowest[k]);
            m_passes[k] = hn::IfThenElse(better, passes, m_passes[k]);
        }
    }
    /// One pass that may lower the block.
    HWY_INLINE void look(const Plane& plane, float pass) {
        const Planes planes{all(plane.middle), all(plane.perColumn), all(plane.perRow), {}};
        look(planes, hn::Eq(planes.middle, planes.middle), all(pass));
    }
    [[nodiscard]] HWY_INLINE std::int32_t at(std::size_t place) const {
        alignas(64) float passes[kBlock];
        hn::Store(m_passes[place], kFloats, passes);
        const V least = hn::MinOfLanes(kFloats, m_lowest[place]);
        return static_cast<std::int32_t>(passes[std::countr_zero(bitsOf(hn::Eq(m_lowest[place], least)))]);
    }

private:
    static constexpr float kColumns[kPlaces] = {0, -5, 5, -5, 5};
    static constexpr float kRows[kPlaces] = {0, -5, -5, 5, 5};

    V m_lowest[kPlaces];
    V m_passes[kPlaces]; ///< whole numbers, exact up to 2²⁴
};

/// Lowers one block by all passes of a table.
class BlockByAll {
public:
    BlockByAll(PassTable& table, TileUnderWork& work, std::size_t block)
        : m_table(table), m_found(table.candidates()), m_work(work), m_block(block) {}

    void lower() {
        if (maximum() <= m_work.floor())
            return;
        Seeds seeds;
        findCandidates(seeds);
        if (m_count == 0)
            return;
        if (!m_work.isKnown(m_block))
            learnMaxima(m_work, m_block);
        for (std::size_t place = 0; place < Seeds::kPlaces; ++place)
            lowerBySeed(seeds.at(place));
        lowerByRest();
    }

private:
    [[nodiscard]] float maximum() const { return m_work.tile().blockMaxima[m_block]; }

    void findCandidates(Seeds& seeds) {
        const V column = all(static_cast<float>(columnOf(m_block)) + kBlockMiddle - kTileMiddle);
        const V row = all(static_cast<float>(rowOf(m_block)) + kBlockMiddle - kTileMiddle);
        const V most = all(maximum());
        const V floor = all(m_work.floor());
        const hn::RebindToSigned<Floats> ints;
        for (std::size_t k = 0; k < m_table.straightCount(); k += kLanes) {
            const Planes planes = supportingPlanes(lanesOf(m_table, k), column, row);
            const V lowest = planes.lowest();
            const M may = hn::And(planes.reaches, hn::Lt(hn::Max(lowest, floor), most));
            if (!any(may))
                continue;
            hn::CompressStore(planes.middle, may, kFloats, &m_found.middle[m_count]);
            hn::CompressStore(planes.perColumn, may, kFloats, &m_found.perColumn[m_count]);
            hn::CompressStore(planes.perRow, may, kFloats, &m_found.perRow[m_count]);
            hn::CompressStore(lowest, may, kFloats, &m_found.lowest[m_count]);
            seeds.look(planes, may, hn::Iota(kFloats, static_cast<float>(k)));
            m_count += hn::CompressStore(hn::Iota(ints, static_cast<std::int32_t>(k)),
                                         hn::RebindMask(ints, may), ints, &m_found.pass[m_count]);
        }
        findRound(seeds);
        // The lanes that fill up the last vector must never be found.
        for (std::size_t k = 0; k < kLanes; ++k)
            m_found.lowest[m_count + k] = kInfinity;
    }

    /// Searches the passes on round paths, which follow the others.
    void findRound(Seeds& seeds) {
        const std::vector<PassTable::RoundPlanes>& rounds = m_table.roundPlanes();
        for (std::size_t k = 0; k < rounds.size(); ++k) {
            const BlockPlanes& planes = rounds[k].planes;
            if ((rounds[k].blocks >> m_block & 1U) == 0)
                continue;
            const auto pass = static_cast<std::int32_t>(m_table.straightCount() + k);
            seeds.look(planeOf(planes, m_block), static_cast<float>(pass));
            m_found.middle[m_count] = planes.middle[m_block];
            m_found.perColumn[m_count] = planes.perColumn[m_block];
            m_found.perRow[m_count] = planes.perRow[m_block];
            m_found.lowest[m_count] = planes.lowest[m_block];
            m_found.pass[m_count++] = pass;
        }
    }

    void lowerBySeed(std::int32_t pass) {
        if (isSeed(pass))
            return;
        m_seeds[m_seedCount++] = pass;
        lowerBy(m_table.passes()[static_cast<std::size_t>(pass)], kAllStrips);
    }

    [[nodiscard]] bool isSeed(std::int32_t pass) const {
        for (std::size_t k = 0; k < m_seedCount; ++k) {
            if (m_seeds[k] == pass)
                return true;
        }
        return false;
    }

    void lowerByRest() {
        for (std::size_t k = 0; k < m_count; k += kLanes) {
            const V lowest = hn::LoadU(kFloats, &m_found.lowest[k]);
            std::uint32_t bits = bitsOf(hn::Lt(lowest, all(maximum())));
            for (; bits != 0; bits &= bits - 1)
                lowerByCandidate(k + static_cast<std::size_t>(std::countr_zero(bits)));
        }
    }

    void lowerByCandidate(std::size_t k) {
        if (m_found.lowest[k] >= maximum() || isSeed(m_found.pass[k]))
            return;
        const Plane plane{m_found.middle[k], m_found.perColumn[k], m_found.perRow[k]};
        const std::uint64_t strips = stripsAbove(plane, m_work.columnMaxima(m_block, 0), m_work.floor());
        if (strips != 0)
            lowerBy(m_table.passes()[static_cast<std::size_t>(m_found.pass[k])], strips);
    }

    void lowerBy(const TilePass& pass, std::uint64_t strips) {
        withAnyEnvelope(pass, [&](const auto& envelope) HWY_ATTR {
            lowerStrips(envelope, pass, m_work, m_block, strips,
                        [](std::size_t, std::size_t) { return NoLosses(); });
        });
    }

    PassTable& m_table;
    PassTable::Candidates& m_found;
    TileUnderWork& m_work;
    std::size_t m_block;
    std::size_t m_count = 0; ///< number of candidates found
    std::int32_t m_seeds[Seeds::kPlaces];
    std::size_t m_seedCount = 0;
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace proveout
HWY_AFTER_NAMESPACE();

#endif
