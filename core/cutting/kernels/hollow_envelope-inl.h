// SPDX-License-Identifier: GPL-3.0-or-later
// The envelope of a hollow on a slope over a vector of points. Compiled once per instruction set.
#if defined(PROVEOUT_CUTTING_HOLLOW_ENVELOPE) == defined(HWY_TARGET_TOGGLE)
#ifdef PROVEOUT_CUTTING_HOLLOW_ENVELOPE
#undef PROVEOUT_CUTTING_HOLLOW_ENVELOPE
#else
#define PROVEOUT_CUTTING_HOLLOW_ENVELOPE
#endif

#include "core/cutting/kernels/band_fit-inl.h"
#include "core/cutting/kernels/pass_envelope-inl.h"

HWY_BEFORE_NAMESPACE();
namespace proveout {
namespace HWY_NAMESPACE {
namespace {

/// A hollow on a slope. It has no closed form: bands give the place where it is lowest, or a search where
/// there are none, along the grid. On the rim it may be lower still.
struct HollowEnvelope {
    HollowForm form;
    BandFit ahead2; ///< over a block
    bool rim;
    V begin, end, z, slope, ahead, flat2, rim2;
    explicit HollowEnvelope(const TilePass& pass)
        : form(pass), ahead2{}, rim(pass.bands == nullptr || pass.bands->rim), begin(all(pass.begin)),
          end(all(pass.end)), z(all(pass.z)), slope(all(pass.slope)),
          ahead(all(pass.slope < 0 ? 1.0F : -1.0F)), flat2(all(pass.flatTo * pass.flatTo)),
          rim2(all(pass.rim2)) {}

    HWY_INLINE Cut operator()(V along, V across) const {
        return withLead(ahead2(hn::Min(square(across), rim2)), along, across);
    }
    /// `leadOfPoint2`: the square of how far ahead it is where it is lowest.
    HWY_INLINE Cut withLead(V leadOfPoint2, V along, V across) const {
        const V across2 = square(across);
        const V off = hn::Sub(along, hn::Min(hn::Max(along, begin), end));
        const M under = hn::Le(productPlus(off, off, across2), rim2);
        const V most2 = hn::Sub(rim2, across2);
        const V touching2 = hn::Max(leadOfPoint2, hn::Sub(flat2, across2));
        const V touching = at(hn::Min(touching2, most2), along, across2);
        return {rim ? hn::Min(touching, at(most2, along, across2)) : touching, under};
    }

private:
    HWY_INLINE V at(V lead2, V along, V across2) const {
        const V place = hn::Min(hn::Max(productPlus(ahead, rootOf(lead2), along), begin), end);
        const V away = hn::Sub(along, place);
        const V distance2 = hn::Min(productPlus(away, away, across2), rim2);
        return hn::Add(productPlus(slope, place, z), form.height(distance2));
    }
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace proveout
HWY_AFTER_NAMESPACE();

#endif
