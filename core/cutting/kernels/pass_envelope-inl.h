// SPDX-License-Identifier: GPL-3.0-or-later
// The envelope of one pass over a vector of points. Compiled once per instruction set.
#if defined(PROVEOUT_CUTTING_PASS_ENVELOPE) == defined(HWY_TARGET_TOGGLE)
#ifdef PROVEOUT_CUTTING_PASS_ENVELOPE
#undef PROVEOUT_CUTTING_PASS_ENVELOPE
#else
#define PROVEOUT_CUTTING_PASS_ENVELOPE
#endif

#include <hwy/highway.h>

#include "core/cutting/kernels/tile_kernel.h"
#include "core/cutting/profiles/level_profile.h"

HWY_BEFORE_NAMESPACE();
namespace proveout {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// The vectors are at most as wide as a row of a block.
using Floats = hn::CappedTag<float, TileUnderWork::kBlock>;
using V = hn::Vec<Floats>;
using M = hn::Mask<Floats>;

inline constexpr Floats kFloats;
inline constexpr int kCornerSteps = 3;
inline constexpr float kNarrow = 1e-6F; ///< mm: the remainder of a corner that touches at its end
inline constexpr float kLevel = 1e-6F;  ///< smaller falls are treated as this: the products of their squares
                                        ///< would vanish
inline constexpr float kTiny = 1e-30F;

HWY_INLINE V all(float value) {
    return hn::Set(kFloats, value);
}
/// Square root of a value that may be below zero through rounding. Correctly rounded everywhere.
HWY_INLINE V rootOf(V value) {
    return hn::Sqrt(hn::Max(value, hn::Zero(kFloats)));
}
HWY_INLINE V square(V value) {
    return hn::Mul(value, value);
}

// A product is rounded before the addition, although some processors can do both in one step: those that
// cannot would give other bits.
HWY_INLINE V productPlus(V a, V b, V c) {
    return hn::Add(hn::Mul(a, b), c);
}
HWY_INLINE V productMinus(V a, V b, V c) {
    return hn::Sub(hn::Mul(a, b), c);
}
/// c - a·b
HWY_INLINE V minusProduct(V a, V b, V c) {
    return hn::Sub(c, hn::Mul(a, b));
}

HWY_INLINE std::uint32_t bitsOf(M mask) {
    std::uint8_t bytes[8] = {}; // the largest number that is written
    hn::StoreMaskBits(kFloats, mask, bytes);
    return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8;
}

// The profile's height above its reference, as a function of the squared distance from the axis.

struct FlatForm {
    explicit FlatForm(const TilePass&) {}
    HWY_INLINE V height(V) const { return hn::Zero(kFloats); }
};

struct LineForm {
    V flatTo, rise;
    explicit LineForm(const TilePass& pass) : flatTo(all(pass.flatTo)), rise(all(pass.rise)) {}
    HWY_INLINE V height(V distance2) const {
        return hn::Mul(rise, hn::Max(hn::Sub(hn::Sqrt(distance2), flatTo), hn::Zero(kFloats)));
    }
};

struct BallForm {
    V radius2;
    explicit BallForm(const TilePass& pass) : radius2(all(pass.radius * pass.radius)) {}
    HWY_INLINE V height(V distance2) const { return hn::Neg(rootOf(hn::Sub(radius2, distance2))); }
};

struct CornerForm {
    V flatTo, ring, radius2;
    explicit CornerForm(const TilePass& pass)
        : flatTo(all(pass.flatTo)), ring(all(pass.ring)), radius2(all(pass.radius * pass.radius)) {}
    HWY_INLINE V height(V distance2) const {
        const V out = hn::Sub(hn::Max(hn::Sqrt(distance2), flatTo), ring);
        return hn::Neg(rootOf(minusProduct(out, out, radius2)));
    }
};

struct HollowForm {
    V flatTo, ring, centre, radius2;
    explicit HollowForm(const TilePass& pass)
        : flatTo(all(pass.flatTo)), ring(all(pass.hollowRing)), centre(all(pass.hollowCentre)),
          radius2(all(pass.hollowRadius2)) {}
    HWY_INLINE V height(V distance2) const {
        const V in = hn::Sub(ring, hn::Max(hn::Sqrt(distance2), flatTo));
        return hn::Add(centre, rootOf(minusProduct(in, in, radius2)));
    }
};

/// Some neighbouring pieces of a whole profile; distances beyond them are never evaluated.
struct WholeForm {
    const LevelProfile::Piece* first;
    std::size_t count;
    explicit WholeForm(const TilePass& pass)
        : first(pass.whole->pieces.data()), count(pass.whole->pieces.size()) {}

    HWY_INLINE V height(V distance2) const {
        const V distance = hn::Sqrt(distance2);
        V height = heightOf(first[count - 1], distance);
        for (std::size_t k = count - 1; k-- > 0;)
            height =
                hn::IfThenElse(hn::Le(distance2, all(first[k].rim2)), heightOf(first[k], distance), height);
        return height;
    }

    /// Keeps only the pieces for distances from `least` to `most`.
    void narrow(float least, float most) {
        while (count > 1 && first->rim2 < least * least) {
            ++first;
            --count;
        }
        while (count > 1 && first[count - 2].rim2 >= most * most)
            --count;
    }

private:
    static HWY_INLINE V heightOf(const LevelProfile::Piece& piece, V distance) {
        const V within = hn::Max(distance, all(piece.r0));
        if (!piece.arc)
            return productPlus(all(piece.rise), hn::Sub(within, all(piece.r0)), all(piece.z0));
        const V out = hn::Sub(within, all(piece.centreR));
        return productPlus(all(piece.side), rootOf(minusProduct(out, out, all(piece.radius2))),
                           all(piece.centreZ));
    }
};

// How far ahead of a point the cutter is, on a slope, where it is lowest over it, as a function of the
// distance across.

struct RimLead {
    V rim2;
    explicit RimLead(const TilePass& pass) : rim2(all(pass.rim2)) {}
    HWY_INLINE V operator()(V across2) const { return rootOf(hn::Sub(rim2, across2)); }
};

struct LineLead {
    V rate2, flatTo2, rim2;
    explicit LineLead(const TilePass& pass)
        : rate2(all(pass.lead)), flatTo2(all(pass.flatTo * pass.flatTo)), rim2(all(pass.rim2)) {}
    HWY_INLINE V operator()(V across2) const {
        const V lead2 = hn::Max(hn::Mul(rate2, across2), hn::Sub(flatTo2, across2));
        return rootOf(hn::Min(lead2, hn::Sub(rim2, across2)));
    }
};

struct BallLead {
    V rate, radius2;
    explicit BallLead(const TilePass& pass) : rate(all(pass.lead)), radius2(all(pass.radius * pass.radius)) {}
    HWY_INLINE V operator()(V across2) const { return hn::Mul(rate, rootOf(hn::Sub(radius2, across2))); }
};

/// The lead of a ball that ends before its arc does.
struct CutOffBallLead {
    BallLead ball;
    RimLead rim;
    explicit CutOffBallLead(const TilePass& pass) : ball(pass), rim(pass) {}
    HWY_INLINE V operator()(V across2) const { return hn::Min(ball(across2), rim(across2)); }
};

/// A quarter circle at the end of the flat.
struct CornerShape {
    V ring, corner, flatTo2, rim2;
    explicit CornerShape(const TilePass& pass)
        : ring(all(pass.ring)), corner(all(pass.radius)), flatTo2(all(pass.flatTo * pass.flatTo)),
          rim2(all(pass.rim2)) {}
};

/// The square of how far ahead the cutter is when it touches with its corner: at the radius r of a profile of
/// slope tan ψ where tan ψ · ahead / r equals the fall. The unknown is v, how far r exceeds the larger of the
/// ring and the distance across. As a function of log(v / (most - v)), the logarithm of the left side is
/// nearly a line, steeper or flatter depending on the place. Newton's steps there, with the logarithm
/// replaced by the first of its fractions, therefore lead from anywhere to within 3e-6 mm of the lowest
/// height in three steps, and no lane waits for another. All powers of the fractions are multiplied out: one
/// division per step, and no root.
HWY_INLINE V cornerAhead2(const CornerShape& shape, V fall, V within2) {
    const V one = all(1);
    const V across = hn::Sqrt(within2);
    const V begin = hn::Max(across, shape.ring);
    const V beside = hn::Sub(begin, across);
    const V most = hn::Max(hn::Sub(hn::Add(shape.ring, shape.corner), begin), all(kNarrow));
    const V ofFall = hn::Max(fall, all(kLevel));
    const V fall2 = square(ofFall);
    const V perCorner = hn::Div(one, shape.corner);
    V v = hn::Mul(most, hn::Div(ofFall, hn::Sqrt(hn::Add(one, fall2))));
    for (int k = 0; k < kCornerSteps; ++k) {
        const V r = hn::Add(begin, v);
        const V rest = hn::Sub(most, v);
        const V sine = hn::Mul(hn::Sub(r, shape.ring), perCorner);
        const V sineMore = productPlus(sine, sine, sine);
        const V ahead2 = hn::Mul(hn::Add(v, beside), hn::Add(r, across));
        const V cosine2 = hn::Mul(hn::Mul(rest, perCorner), hn::Add(one, sine));
        const V is = hn::Mul(square(sine), ahead2);
        const V wanted = hn::Mul(hn::Mul(fall2, cosine2), square(r));
        const V far = hn::Mul(r, ahead2);
        const V least = hn::Mul(hn::Mul(sineMore, most), far);
        const V growth = hn::Mul(hn::Mul(all(2), v), productPlus(hn::Mul(within2, rest), sineMore, far));
        const V sum = hn::Mul(growth, hn::Add(wanted, is));
        const V difference = hn::Mul(least, hn::Sub(wanted, is));
        const V lowest = hn::Mul(sum, all(0.05F));
        const V up = hn::Mul(v, hn::Max(hn::Add(sum, difference), lowest));
        const V down = hn::Mul(rest, hn::Max(hn::Sub(sum, difference), lowest));
        v = hn::Div(hn::Mul(most, up), hn::Add(up, down));
    }
    return hn::Mul(hn::Add(v, beside), productPlus(all(2), across, hn::Add(v, beside)));
}
/// The lead itself, limited so that it is neither on the flat nor beyond the rim.
HWY_INLINE V cornerLeadOf(const CornerShape& shape, V ahead2, V within2) {
    const V lead2 = hn::Max(ahead2, hn::Sub(shape.flatTo2, within2));
    return rootOf(hn::Min(lead2, hn::Sub(shape.rim2, within2)));
}
HWY_INLINE V cornerLead(const CornerShape& shape, V fall, V across2) {
    const V within2 = hn::Min(across2, shape.rim2);
    return cornerLeadOf(shape, cornerAhead2(shape, fall, within2), within2);
}

struct CornerLead {
    CornerShape shape;
    V fall;
    explicit CornerLead(const TilePass& pass) : shape(pass), fall(hn::Abs(all(pass.slope))) {}
    HWY_INLINE V operator()(V across2) const { return cornerLead(shape, fall, across2); }
};

/// The envelope, and which lanes are under the cutter.
struct Cut {
    V z;
    M under;
};

template<class Form>
struct LevelEnvelope {
    Form form;
    V begin, end, z, rim2, from;
    explicit LevelEnvelope(const TilePass& pass)
        : form(pass), begin(all(pass.begin)), end(all(pass.end)), z(all(pass.z)), rim2(all(pass.rim2)),
          from(all(pass.from)) {}
    HWY_INLINE V distance2(V along, V across) const {
        const V off = hn::Sub(along, hn::Min(hn::Max(along, begin), end));
        return productPlus(off, off, square(across));
    }
    HWY_INLINE Cut operator()(V along, V across) const {
        const V nearest2 = distance2(along, across);
        return {hn::Add(z, form.height(nearest2)), hn::And(hn::Le(nearest2, rim2), hn::Gt(along, from))};
    }
};

template<class Form, class Lead>
struct SlopedEnvelope {
    Form form;
    Lead lead;
    V begin, end, z, slope, ahead, rim2, from;
    explicit SlopedEnvelope(const TilePass& pass) : SlopedEnvelope(pass, Lead(pass)) {}
    SlopedEnvelope(const TilePass& pass, const Lead& leadOfPass)
        : form(pass), lead(leadOfPass), begin(all(pass.begin)), end(all(pass.end)), z(all(pass.z)),
          slope(all(pass.slope)), ahead(all(pass.slope < 0 ? 1.0F : -1.0F)), rim2(all(pass.rim2)),
          from(all(pass.from)) {}
    HWY_INLINE Cut operator()(V along, V across) const {
        return withLead(lead(square(across)), along, across);
    }
    /// The same where the lead is known.
    HWY_INLINE Cut withLead(V leadOfPoint, V along, V across) const {
        const V across2 = square(across);
        const V off = hn::Sub(along, hn::Min(hn::Max(along, begin), end));
        const V wanted = productPlus(ahead, leadOfPoint, along);
        const M under = hn::And(hn::Le(productPlus(off, off, across2), rim2), hn::Gt(wanted, from));
        const V place = hn::Min(hn::Max(wanted, begin), end);
        const V away = hn::Sub(along, place);
        const V height = form.height(productPlus(away, away, across2));
        return {hn::Add(productPlus(slope, place, z), height), under};
    }
};

/// Calls `work` with the envelope of a pass: one type per form and slope, so that loops are compiled for it.
template<class Work>
HWY_INLINE void withEnvelope(const TilePass& pass, const Work& work) {
    switch (pass.form) {
    case TilePass::Form::flat:
        if (pass.level)
            return work(LevelEnvelope<FlatForm>(pass));
        return work(SlopedEnvelope<FlatForm, RimLead>(pass));
    case TilePass::Form::line:
        if (pass.level)
            return work(LevelEnvelope<LineForm>(pass));
        if (pass.lead < 0)
            return work(SlopedEnvelope<LineForm, RimLead>(pass));
        return work(SlopedEnvelope<LineForm, LineLead>(pass));
    case TilePass::Form::ball:
        if (pass.level)
            return work(LevelEnvelope<BallForm>(pass));
        if (pass.rim2 < pass.radius * pass.radius)
            return work(SlopedEnvelope<BallForm, CutOffBallLead>(pass));
        return work(SlopedEnvelope<BallForm, BallLead>(pass));
    case TilePass::Form::corner:
        if (pass.level)
            return work(LevelEnvelope<CornerForm>(pass));
        return work(SlopedEnvelope<CornerForm, CornerLead>(pass));
    case TilePass::Form::hollow:
        return work(SlopedEnvelope<HollowForm, RimLead>(pass)); // others: HollowEnvelope
    case TilePass::Form::whole:
        return work(LevelEnvelope<WholeForm>(pass));
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace proveout
HWY_AFTER_NAMESPACE();

#endif
