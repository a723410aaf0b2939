// SPDX-License-Identifier: GPL-3.0-or-later
// The envelope of one pass over a vector of points. Compiled once an instruction set.
#if defined(PROVEOUT_CUTTING_PASS_ENVELOPE) == defined(HWY_TARGET_TOGGLE)
#ifdef PROVEOUT_CUTTING_PASS_ENVELOPE
#undef PROVEOUT_CUTTING_PASS_ENVELOPE
#else
#define PROVEOUT_CUTTING_PASS_ENVELOPE
#endif

#include <hwy/highway.h>

#include "core/cutting/tile_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace proveout {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// A row of a block is as wide as the widest vector.
using Floats = hn::CappedTag<float, TileUnderWork::kBlock>;
using V = hn::Vec<Floats>;
using M = hn::Mask<Floats>;

inline constexpr Floats kFloats;
inline constexpr int kMostSteps = 60;  ///< of Newton
inline constexpr float kStill = 1e-5F; ///< of a sine; what stands still is lowest there to its square
inline constexpr float kTiny = 1e-30F;

HWY_INLINE V all(float value) {
    return hn::Set(kFloats, value);
}
/// Square root of what may be below zero by rounding. Correctly rounded everywhere.
HWY_INLINE V rootOf(V value) {
    return hn::Sqrt(hn::Max(value, hn::Zero(kFloats)));
}
HWY_INLINE V square(V value) {
    return hn::Mul(value, value);
}

// A product is rounded before it is added to, although processors can do otherwise: those that cannot would
// give other bits.
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
    std::uint8_t bytes[8] = {}; // as many as are written at most
    hn::StoreMaskBits(kFloats, mask, bytes);
    return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8;
}

// The profile's height above its reference, by the squared distance from the axis.

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

// How far ahead of a point the cutter stands, on a slope, where it is lowest over it; by the distance across.

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

/// Of a ball that ends before its arc does.
struct CutOffBallLead {
    BallLead ball;
    RimLead rim;
    explicit CutOffBallLead(const TilePass& pass) : ball(pass), rim(pass) {}
    HWY_INLINE V operator()(V across2) const { return hn::Min(ball(across2), rim(across2)); }
};

/// See touchingRadius() in straight_sweep.cpp. Every lane stops by itself, so that its steps do not depend on
/// its neighbours, nor on how many there are.
struct CornerLead {
    V ring, corner, fall, fall2, flatTo2, rim2;
    explicit CornerLead(const TilePass& pass)
        : ring(all(pass.ring)), corner(all(pass.radius)), fall(hn::Abs(all(pass.slope))), fall2(square(fall)),
          flatTo2(all(pass.flatTo * pass.flatTo)), rim2(all(pass.rim2)) {}

    HWY_INLINE V sine(V r, V across2) const {
        const V r2 = square(r);
        return hn::Div(hn::Mul(fall, r),
                       hn::Sqrt(hn::Max(productPlus(fall2, r2, hn::Sub(r2, across2)), all(kTiny))));
    }
    HWY_INLINE V step(V sigma, V across2) const {
        const V one = all(1);
        const V r = productPlus(corner, sigma, ring);
        const V reach = productMinus(r, r, across2);
        const V sigma2 = square(sigma);
        const V cosine2 = hn::Sub(one, sigma2);
        const V weight = hn::Mul(fall2, r);
        const V value = minusProduct(hn::Mul(weight, r), cosine2, hn::Mul(sigma2, reach));
        const V inward = hn::Mul(corner, minusProduct(weight, cosine2, hn::Mul(r, sigma2)));
        const V rise = productPlus(sigma, productPlus(weight, r, reach), inward);
        return hn::Div(hn::Mul(all(0.5F), value), rise);
    }
    HWY_INLINE V operator()(V across2) const {
        const V within2 = hn::Min(across2, rim2);
        const V low =
            hn::Max(sine(hn::Add(ring, corner), within2), hn::Div(hn::Sub(hn::Sqrt(within2), ring), corner));
        V sigma = hn::Min(all(1), sine(productPlus(corner, low, ring), within2));
        M moving = hn::Eq(sigma, sigma);
        for (int k = 0; k < kMostSteps; ++k) {
            const V back = step(sigma, within2);
            moving = hn::And(moving, hn::Gt(back, all(kStill)));
            if (hn::AllFalse(kFloats, moving))
                break;
            sigma = hn::IfThenElse(moving, hn::Sub(sigma, back), sigma);
        }
        const V r = productPlus(corner, sigma, ring);
        const V lead2 = hn::Max(productMinus(r, r, within2), hn::Sub(flatTo2, within2));
        return rootOf(hn::Min(lead2, hn::Sub(rim2, within2)));
    }
};

/// The envelope, and which lanes are under the cutter.
struct Cut {
    V z;
    M under;
};

template<class Form>
struct LevelEnvelope {
    Form form;
    V begin, end, z, rim2;
    explicit LevelEnvelope(const TilePass& pass)
        : form(pass), begin(all(pass.begin)), end(all(pass.end)), z(all(pass.z)), rim2(all(pass.rim2)) {}
    HWY_INLINE Cut operator()(V along, V across) const {
        const V off = hn::Sub(along, hn::Min(hn::Max(along, begin), end));
        const V distance2 = productPlus(off, off, square(across));
        return {hn::Add(z, form.height(distance2)), hn::Le(distance2, rim2)};
    }
};

template<class Form, class Lead>
struct SlopedEnvelope {
    Form form;
    Lead lead;
    V begin, end, z, slope, ahead, rim2;
    explicit SlopedEnvelope(const TilePass& pass)
        : form(pass), lead(pass), begin(all(pass.begin)), end(all(pass.end)), z(all(pass.z)),
          slope(all(pass.slope)), ahead(all(pass.slope < 0 ? 1.0F : -1.0F)), rim2(all(pass.rim2)) {}
    HWY_INLINE Cut operator()(V along, V across) const {
        const V across2 = square(across);
        const V off = hn::Sub(along, hn::Min(hn::Max(along, begin), end));
        const M under = hn::Le(productPlus(off, off, across2), rim2);
        const V place = hn::Min(hn::Max(productPlus(ahead, lead(across2), along), begin), end);
        const V away = hn::Sub(along, place);
        const V height = form.height(productPlus(away, away, across2));
        return {hn::Add(productPlus(slope, place, z), height), under};
    }
};

/// Calls `work` with the envelope of a pass: one type a form and slope, so that loops are compiled for it.
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
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace proveout
HWY_AFTER_NAMESPACE();

#endif
