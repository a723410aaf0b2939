// SPDX-License-Identifier: GPL-3.0-or-later
// Fits leads by polynomials and evaluates them. Compiled once per instruction set.
#if defined(PROVEOUT_CUTTING_BAND_FIT) == defined(HWY_TARGET_TOGGLE)
#ifdef PROVEOUT_CUTTING_BAND_FIT
#undef PROVEOUT_CUTTING_BAND_FIT
#else
#define PROVEOUT_CUTTING_BAND_FIT
#endif

#include <array>

#include "core/cutting/kernels/block_places-inl.h"
#include "core/cutting/kernels/lead_bands.h"

HWY_BEFORE_NAMESPACE();
namespace proveout {
namespace HWY_NAMESPACE {
namespace {

/// The error of heights that is generally acceptable, mm.
inline constexpr float kFitError = 3e-5F;

/// Neighbouring bands of a variable, as many as a block needs.
struct BandFit {
    const LeadBands::Band* first;
    std::size_t count;

    /// Outside of all bands: the value at the nearest end.
    HWY_INLINE V operator()(V variable) const {
        V value = of(first[0], variable);
        for (std::size_t k = 1; k < count; ++k)
            value = hn::IfThenElse(hn::Ge(variable, all(first[k].begin)), of(first[k], variable), value);
        return value;
    }

private:
    static HWY_INLINE V of(const LeadBands::Band& band, V variable) {
        const V place = hn::Mul(hn::Sub(variable, all(band.middle)), all(band.perHalf));
        const V x = hn::Max(hn::Min(place, all(1)), all(-1));
        V sum = all(band.coefficients[LeadBands::kDegree]);
        for (std::size_t k = LeadBands::kDegree; k-- > 0;)
            sum = productPlus(sum, x, all(band.coefficients[k]));
        return sum;
    }
};

/// The bands that a variable from `least` to `most` passes through.
HWY_INLINE BandFit bandsBetween(const LeadBands& bands, float least, float most) {
    std::size_t begin = 0;
    while (begin + 1 < bands.count && bands.bands[begin + 1].begin <= least)
        ++begin;
    std::size_t end = begin + 1;
    while (end < bands.count && bands.bands[end].begin <= most)
        ++end;
    return {&bands.bands[begin], end - begin};
}

/// The places in [-1, 1] where a polynomial is compared with the function that it approximates: the extremes
/// of a Chebyshev polynomial, dense at both ends. The polynomial is fitted to be equal in every third of
/// them.
inline constexpr std::size_t kNodes = kBlock; ///< a number that fills whole vectors of any width
inline constexpr float kNodePlaces[kNodes] = {1.0F,          0.978147601F,  0.913545458F,  0.809016994F,
                                              0.669130606F,  0.5F,          0.309016994F,  0.104528463F,
                                              -0.104528463F, -0.309016994F, -0.5F,         -0.669130606F,
                                              -0.809016994F, -0.913545458F, -0.978147601F, -1.0F};

/// The polynomial with these values in the nodes.
inline LeadBands::Band bandOf(float begin, float end, const float* values) {
    constexpr std::size_t kLast = kNodes - 1;
    constexpr std::size_t kStep = 3;
    std::array<float, 3> even{};
    std::array<float, 3> odd{};
    for (std::size_t k = 0; k < even.size(); ++k) {
        even[k] = values[k * kStep] + values[kLast - k * kStep];
        odd[k] = values[k * kStep] - values[kLast - k * kStep];
    }
    const auto sum = [](const std::array<float, 3>& of, float a, float b, float c) {
        return a * of[0] + b * of[1] + c * of[2];
    };
    // The inverse of the matrix of powers of the six places.
    return {begin,
            0.5F * (begin + end),
            2.0F / (end - begin),
            {sum(even, 0.1F, -0.247213595F, 0.647213595F), sum(odd, 0.1F, -0.305572809F, 2.09442719F),
             sum(even, -1.2F, 2.83606798F, -1.63606798F), sum(odd, -1.2F, 3.50557281F, -5.29442719F),
             sum(even, 1.6F, -2.58885438F, 0.988854382F), sum(odd, 1.6F, -3.2F, 3.2F)}};
}

/// Fits the polynomial over [begin, end] and returns whether it is near enough. `solved` is the function that
/// it approximates: value() gives it by the variable and where it counts, and height() the height of a point
/// from that value, in mm.
template<class Solved>
HWY_INLINE bool fitBand(Solved& solved, float begin, float end, LeadBands::Band& band) {
    const V middle = all(0.5F * (begin + end));
    const V half = all(0.5F * (end - begin));
    alignas(64) float values[kNodes];
    M counts[kVectors];
    const auto nodes = [&](std::size_t vector) HWY_ATTR {
        return productPlus(hn::LoadU(kFloats, kNodePlaces + vector * kLanes), half, middle);
    };
    for (std::size_t k = 0; k < kVectors; ++k)
        hn::Store(solved.value(nodes(k), counts[k]), kFloats, values + k * kLanes);
    band = bandOf(begin, end, values);
    const BandFit fit{&band, 1};
    V apart = hn::Zero(kFloats);
    for (std::size_t k = 0; k < kVectors; ++k) {
        const V place = nodes(k);
        const V height = solved.height(place, hn::Load(kFloats, values + k * kLanes));
        const V off = hn::Abs(hn::Sub(solved.height(place, fit(place)), height));
        apart = hn::Max(apart, hn::IfThenElseZero(counts[k], off));
    }
    return hn::AllTrue(kFloats, hn::Le(apart, all(solved.error())));
}

/// Adds bands over [begin, end], halved until they are near enough; false if that needs too many.
template<class Solved>
bool fitBands(Solved& solved, float begin, float end, LeadBands& bands) {
    std::array<float, LeadBands::kMost> ends{};
    std::size_t waiting = 1;
    ends[0] = end;
    if (bands.count == LeadBands::kMost)
        return false;
    while (waiting > 0) {
        if (fitBand(solved, begin, ends[waiting - 1], bands.bands[bands.count])) {
            ++bands.count;
            begin = ends[--waiting];
        } else if (bands.count + waiting < LeadBands::kMost) {
            ends[waiting] = 0.5F * (begin + ends[waiting - 1]);
            ++waiting;
        } else {
            return false;
        }
    }
    return true;
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace proveout
HWY_AFTER_NAMESPACE();

#endif
