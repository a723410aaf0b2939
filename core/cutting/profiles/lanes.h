// SPDX-License-Identifier: GPL-3.0-or-later
// Eight points processed together, for the solvers that iterate: plain arithmetic on them becomes vector code
// of the width that the processor has, and an iteration ends once no lane moves.
#pragma once

#include <cmath>

namespace proveout {

inline constexpr int kLanes = 8;
/// Vectors of GCC and Clang; arithmetic, comparison and ?: work lane by lane.
using Lanes = double __attribute__((vector_size(kLanes * sizeof(double))));
using LaneMask = decltype(Lanes{} < Lanes{});

// A call would pass 64 bytes in registers that only some processors have, so everything is inlined.
#define PROVEOUT_LANES [[gnu::always_inline]] inline

PROVEOUT_LANES Lanes allLanes(double value) {
    return Lanes{} + value;
}
/// start, start + step, …
PROVEOUT_LANES Lanes ramp(double start, double step) {
    return start + step * Lanes{0, 1, 2, 3, 4, 5, 6, 7};
}
PROVEOUT_LANES Lanes lesser(const Lanes& a, const Lanes& b) {
    return a < b ? a : b;
}
PROVEOUT_LANES Lanes greater(const Lanes& a, const Lanes& b) {
    return a > b ? a : b;
}
PROVEOUT_LANES Lanes magnitude(const Lanes& a) {
    return greater(a, -a);
}
PROVEOUT_LANES Lanes sqrtOf(const Lanes& a) {
    Lanes roots;
    for (int k = 0; k < kLanes; ++k)
        roots[k] = std::sqrt(a[k]);
    return roots;
}
/// Square roots of values that may be below zero through rounding.
PROVEOUT_LANES Lanes rootOf(const Lanes& a) {
    return sqrtOf(greater(a, Lanes{}));
}
PROVEOUT_LANES bool any(const LaneMask& mask) {
    bool found = false;
    for (int k = 0; k < kLanes; ++k)
        found |= mask[k] != 0;
    return found;
}

/// The first `count` of eight heights, the rest 0.
PROVEOUT_LANES Lanes load(const float* heights, int count) {
    Lanes lanes{};
    for (int k = 0; k < (count < kLanes ? count : kLanes); ++k)
        lanes[k] = static_cast<double>(heights[k]);
    return lanes;
}
/// Lowers the first `count` of eight heights.
PROVEOUT_LANES void storeLower(const Lanes& z, int count, float* out) {
    for (int k = 0; k < (count < kLanes ? count : kLanes); ++k) {
        const auto cut = static_cast<float>(z[k]);
        out[k] = cut < out[k] ? cut : out[k];
    }
}

/// For a corner arc: the radii where its surface touches lowest, per lane; see lead() in straight_sweep.h.
///
/// With r = ring + corner·σ the stationary place satisfies σ²(r² - across²) = fall² r² (1 - σ²). As a
/// polynomial in σ its signs are + + ? - -, so it has one positive root, and it is convex to the right of
/// that root: Newton from any place to the right converges to the root without ever passing it.
PROVEOUT_LANES Lanes touchingRadii(double ring, double corner, const Lanes& fall, const Lanes& across2) {
    constexpr int kMostSteps = 60;
    constexpr double kStill = 1e-13;
    constexpr double kTiny = 1e-300;
    const Lanes fall2 = fall * fall;
    // The fixed-point form σ = sine(ring + corner·σ) falls with σ: its value for the largest σ bounds the
    // root from below, and its value for that bound bounds the root from above.
    const auto sine = [&](const Lanes& r) __attribute__((always_inline)) {
        return fall * r / sqrtOf(greater((r * r - across2) + fall2 * r * r, allLanes(kTiny)));
    };
    const Lanes low = greater(sine(allLanes(ring + corner)), (rootOf(across2) - ring) / corner);
    Lanes sigma = lesser(allLanes(1), sine(ring + corner * low));
    for (int step = 0; step < kMostSteps; ++step) {
        const Lanes r = ring + corner * sigma;
        const Lanes reach = r * r - across2;
        const Lanes sigma2 = sigma * sigma;
        const Lanes weight = fall2 * r;
        const Lanes value = sigma2 * reach - weight * r * (1 - sigma2);
        const Lanes rise =
            2 * (sigma * reach + corner * r * sigma2 - corner * weight * (1 - sigma2) + weight * r * sigma);
        const Lanes back = value / rise;
        sigma -= back > 0 ? back : Lanes{};
        if (!any(back > kStill))
            break;
    }
    return ring + corner * sigma;
}

} // namespace proveout
