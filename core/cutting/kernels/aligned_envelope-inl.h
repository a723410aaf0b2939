// SPDX-License-Identifier: GPL-3.0-or-later
// Envelopes of slopes along a row or a column of the grid: the points of a row have one distance from the
// path, and one lead. Compiled once per instruction set.
#if defined(PROVEOUT_CUTTING_ALIGNED_ENVELOPE) == defined(HWY_TARGET_TOGGLE)
#ifdef PROVEOUT_CUTTING_ALIGNED_ENVELOPE
#undef PROVEOUT_CUTTING_ALIGNED_ENVELOPE
#else
#define PROVEOUT_CUTTING_ALIGNED_ENVELOPE
#endif

#include <algorithm>

#include "core/cutting/kernels/block_places-inl.h"

HWY_BEFORE_NAMESPACE();
namespace proveout {
namespace HWY_NAMESPACE {
namespace {

/// A path along the rows of a block. `lead` gives leads by the square of the distance from the path.
template<class Envelope>
struct RowsEnvelope {
    static constexpr std::uint64_t kStripsOfVector =
        (1U << std::max<std::size_t>(kLanes / kGroupRows, 1) * kVectors) - 1;
    Envelope envelope;
    alignas(64) float leads[kBlock]; ///< of the rows of `strips`, one bit each

    template<class Lead>
    HWY_INLINE RowsEnvelope(const Envelope& of, const Lead& lead, const BlockPlaces& places,
                            std::uint64_t strips)
        : envelope(of) {
        alignas(64) float across[kBlock];
        for (std::size_t r = 0; r < kBlock; ++r)
            across[r] = places.acrossAt(r);
        for (std::size_t r = 0; r < kBlock; r += kLanes) {
            if ((strips >> r / kGroupRows * kVectors & kStripsOfVector) != 0)
                hn::Store(lead(square(hn::Load(kFloats, across + r))), kFloats, leads + r);
        }
    }
    HWY_INLINE Cut at(std::size_t row, std::size_t, V along, V across) const {
        return envelope.withLead(all(leads[row]), along, across);
    }
};

/// A path along the columns of a block.
template<class Envelope>
struct ColumnsEnvelope {
    Envelope envelope;
    V leads[kVectors];

    template<class Lead>
    HWY_INLINE ColumnsEnvelope(const Envelope& of, const Lead& lead, const BlockPlaces& places)
        : envelope(of) {
        for (std::size_t k = 0; k < kVectors; ++k)
            leads[k] = lead(square(places.acrossAt(0, k)));
    }
    HWY_INLINE Cut at(std::size_t, std::size_t vector, V along, V across) const {
        return envelope.withLead(leads[vector], along, across);
    }
};

/// The envelope at a vector of a row; `r`, `k` as in BlockPlaces.
template<class Envelope>
HWY_INLINE Cut cutAt(const Envelope& envelope, std::size_t, std::size_t, V along, V across) {
    return envelope(along, across);
}
template<class Envelope>
HWY_INLINE Cut cutAt(const RowsEnvelope<Envelope>& envelope, std::size_t r, std::size_t k, V along,
                     V across) {
    return envelope.at(r, k, along, across);
}
template<class Envelope>
HWY_INLINE Cut cutAt(const ColumnsEnvelope<Envelope>& envelope, std::size_t r, std::size_t k, V along,
                     V across) {
    return envelope.at(r, k, along, across);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace proveout
HWY_AFTER_NAMESPACE();

#endif
