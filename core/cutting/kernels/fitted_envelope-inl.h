// SPDX-License-Identifier: GPL-3.0-or-later
// Envelopes whose leads are given by bands. Compiled once per instruction set.
#if defined(PROVEOUT_CUTTING_FITTED_ENVELOPE) == defined(HWY_TARGET_TOGGLE)
#ifdef PROVEOUT_CUTTING_FITTED_ENVELOPE
#undef PROVEOUT_CUTTING_FITTED_ENVELOPE
#else
#define PROVEOUT_CUTTING_FITTED_ENVELOPE
#endif

#include <algorithm>
#include <cmath>

#include "core/cutting/kernels/aligned_envelope-inl.h"
#include "core/cutting/kernels/band_fit-inl.h"
#include "core/cutting/kernels/lead_search-inl.h"
#include "core/cutting/kernels/round_envelope-inl.h"

HWY_BEFORE_NAMESPACE();
namespace proveout {
namespace HWY_NAMESPACE {
namespace {

/// With more bands in a block, evaluating them costs as much as solving it.
inline constexpr std::size_t kMostBands = 7;

struct FittedCornerLead {
    CornerShape shape;
    BandFit ahead2;
    HWY_INLINE V operator()(V across2) const {
        const V within2 = hn::Min(across2, shape.rim2);
        return cornerLeadOf(shape, ahead2(within2), within2);
    }
};

/// For fitBands(): the lead on a straight path, as the function to be fitted.
struct SolvedCornerLead {
    CornerForm form;
    CornerLead lead;
    explicit SolvedCornerLead(const TilePass& pass) : form(pass), lead(pass) {}
    [[nodiscard]] static float error() { return kFitError; }
    HWY_INLINE V value(V across2, M& counts) const {
        counts = hn::Eq(across2, across2);
        return cornerAhead2(lead.shape, lead.fall, across2);
    }
    HWY_INLINE V height(V across2, V ahead2) const {
        const V ahead = cornerLeadOf(lead.shape, ahead2, across2);
        return minusProduct(lead.fall, ahead, form.height(productPlus(ahead, ahead, across2)));
    }
};

struct SearchedHollowLead {
    mutable LeadSearch<HollowForm, StraightWay> search;
    V rim2;
    explicit SearchedHollowLead(const TilePass& pass) : search(pass), rim2(all(pass.rim2)) {}
    HWY_INLINE V operator()(V across2) const { return search.ahead2(hn::Min(across2, rim2)); }
};

/// The bands for the squares of the distances across in a block, as far as they are under the cutter.
HWY_INLINE BandFit bandsAcross(const TilePass& pass, std::size_t block) {
    const BlockMiddle at(block);
    const float half = kBlockMiddle * (std::abs(pass.acrossX) + std::abs(pass.acrossY));
    const float middle = std::abs(pass.across + at.column * pass.acrossX + at.row * pass.acrossY);
    const float nearest = std::max(middle - half, 0.0F);
    const float farthest = middle + half;
    return bandsBetween(*pass.bands, nearest * nearest, farthest * farthest);
}

/// The bands for the distances outside of a circle.
HWY_INLINE BandFit bandsOutside(const TilePass& pass, std::size_t block) {
    const BlockMiddle at(block);
    const TilePass::Round& round = pass.round;
    const float along = round.middleAlong + at.column * pass.alongX + at.row * pass.alongY;
    const float across = round.middleAcross + at.column * pass.acrossX + at.row * pass.acrossY;
    const float outside = std::sqrt(along * along + across * across) - round.radius;
    return bandsBetween(*pass.bands, outside - round.blockReach, outside + round.blockReach);
}

/// Whether an envelope has a form over one block that costs less.
template<class Envelope>
inline constexpr bool kOfBlocks = false;
template<class Form, class Lead>
inline constexpr bool kOfBlocks<SlopedEnvelope<Form, Lead>> = true;
template<>
inline constexpr bool kOfBlocks<HollowEnvelope> = true;
template<class Form>
inline constexpr bool kOfBlocks<HelixEnvelope<Form>> = true;
template<>
inline constexpr bool kOfBlocks<LevelEnvelope<WholeForm>> = true;
template<>
inline constexpr bool kOfBlocks<LevelRoundEnvelope<WholeForm>> = true;

/// Whether the path is along the rows or columns of the grid.
HWY_INLINE bool alongGrid(const TilePass& pass) {
    return pass.acrossX == 0 || pass.acrossY == 0;
}
template<class Envelope, class Lead, class Work>
HWY_INLINE void withAlignedEnvelope(const Envelope& envelope, const Lead& lead, const TilePass& pass,
                                    const BlockPlaces& places, std::uint64_t strips, const Work& work) {
    if (pass.acrossX == 0)
        work(RowsEnvelope<Envelope>(envelope, lead, places, strips));
    else
        work(ColumnsEnvelope<Envelope>(envelope, lead, places));
}

// Each calls `work` with that form.

template<class Form, class Lead, class Work>
HWY_INLINE void withBlockEnvelope(const SlopedEnvelope<Form, Lead>& envelope, const TilePass& pass,
                                  const BlockPlaces& places, std::size_t, std::uint64_t strips,
                                  const Work& work) {
    if (alongGrid(pass))
        return withAlignedEnvelope(envelope, envelope.lead, pass, places, strips, work);
    work(envelope);
}

template<class Work>
HWY_INLINE void withBlockEnvelope(const SlopedEnvelope<CornerForm, CornerLead>& envelope,
                                  const TilePass& pass, const BlockPlaces& places, std::size_t block,
                                  std::uint64_t strips, const Work& work) {
    if (alongGrid(pass))
        return withAlignedEnvelope(envelope, envelope.lead, pass, places, strips, work);
    if (pass.bands == nullptr)
        return work(envelope);
    const BandFit bands = bandsAcross(pass, block);
    if (bands.count > kMostBands)
        return work(envelope);
    work(SlopedEnvelope<CornerForm, FittedCornerLead>(pass, {envelope.lead.shape, bands}));
}

template<class Work>
HWY_INLINE void withBlockEnvelope(const HollowEnvelope& envelope, const TilePass& pass,
                                  const BlockPlaces& places, std::size_t block, std::uint64_t strips,
                                  const Work& work) {
    if (pass.bands == nullptr)
        return withAlignedEnvelope(envelope, SearchedHollowLead(pass), pass, places, strips, work);
    HollowEnvelope narrow = envelope;
    narrow.ahead2 = bandsAcross(pass, block);
    work(narrow);
}

template<class Form, class Work>
HWY_INLINE void withBlockEnvelope(const HelixEnvelope<Form>& envelope, const TilePass& pass,
                                  const BlockPlaces&, std::size_t block, std::uint64_t, const Work& work) {
    HelixEnvelope<Form> narrow = envelope;
    narrow.chord2 = bandsOutside(pass, block);
    work(narrow);
}

/// The same envelope with only those pieces of the profile that correspond to the block's distances from the
/// path.
template<class Envelope>
HWY_INLINE Envelope narrowed(const Envelope& envelope, const TilePass& pass, std::size_t block) {
    constexpr float kSlack = 1e-3F; // mm: more than rounding can lose
    const BlockMiddle at(block);
    const float along = pass.along + at.column * pass.alongX + at.row * pass.alongY;
    const float across = pass.across + at.column * pass.acrossX + at.row * pass.acrossY;
    const float distance = std::sqrt(hn::GetLane(envelope.distance2(all(along), all(across))));
    const float perColumn = pass.alongX * pass.alongX + pass.acrossX * pass.acrossX;
    const float perRow = pass.alongY * pass.alongY + pass.acrossY * pass.acrossY;
    const float reach = kBlockMiddle * std::sqrt(perColumn + perRow) + kSlack;
    Envelope narrow = envelope;
    narrow.form.narrow(std::max(distance - reach, 0.0F), distance + reach);
    return narrow;
}

template<class Work>
HWY_INLINE void withBlockEnvelope(const LevelEnvelope<WholeForm>& envelope, const TilePass& pass,
                                  const BlockPlaces&, std::size_t block, std::uint64_t, const Work& work) {
    work(narrowed(envelope, pass, block));
}

template<class Work>
HWY_INLINE void withBlockEnvelope(const LevelRoundEnvelope<WholeForm>& envelope, const TilePass& pass,
                                  const BlockPlaces&, std::size_t block, std::uint64_t, const Work& work) {
    work(narrowed(envelope, pass, block));
}

template<class Form, class Way>
bool fitAll(LeadSearch<Form, Way>& search, const TilePass& pass, LeadBands& bands) {
    return fitBands(search, Way::least(pass), Way::most(pass), bands);
}

/// Beside the edge of its flat a hollow may touch over a narrow strip, which the bands must not miss.
template<class Way>
bool fitAll(LeadSearch<HollowForm, Way>& search, const TilePass& pass, LeadBands& bands) {
    constexpr int kParts = 4;
    float from = Way::least(pass);
    for (const float to : {Way::innerEdge(pass), Way::outerEdge(pass), Way::most(pass)}) {
        const float part = (to - from) / kParts;
        for (int k = 0; k < kParts && part > 0; ++k) {
            const float begin = from + static_cast<float>(k) * part;
            if (!fitBands(search, begin, k + 1 < kParts ? begin + part : to, bands))
                return false;
        }
        from = std::max(from, to);
    }
    return true;
}

template<class Form, class Way>
bool fitSearched(const TilePass& pass, LeadBands& bands) {
    LeadSearch<Form, Way> search(pass);
    const bool fitted = fitAll(search, pass, bands);
    bands.rim = search.leaves();
    return fitted && !search.ambiguous();
}

inline bool fitStraightBands(const TilePass& pass, LeadBands& bands) {
    if (pass.form == TilePass::Form::hollow)
        return fitSearched<HollowForm, StraightWay>(pass, bands);
    SolvedCornerLead lead(pass);
    return pass.form == TilePass::Form::corner && fitBands(lead, 0.0F, pass.rim2, bands);
}

/// Fits the bands of a pass; false if there are none.
inline bool fitPassBands(const TilePass& pass, LeadBands& bands) {
    if (pass.path == TilePass::Path::straight)
        return fitStraightBands(pass, bands);
    switch (pass.form) {
    case TilePass::Form::flat:
        return fitSearched<FlatForm, RoundWay>(pass, bands);
    case TilePass::Form::line:
        return fitSearched<LineForm, RoundWay>(pass, bands);
    case TilePass::Form::ball:
        return fitSearched<BallForm, RoundWay>(pass, bands);
    case TilePass::Form::corner:
        return fitSearched<CornerForm, RoundWay>(pass, bands);
    case TilePass::Form::hollow:
        return fitSearched<HollowForm, RoundWay>(pass, bands);
    case TilePass::Form::whole:
        break;
    }
    return false;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace proveout
HWY_AFTER_NAMESPACE();

#endif
