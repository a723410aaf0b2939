// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/cost_model.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

#include "core/study/averages.h"

namespace proveout {

namespace {

constexpr std::size_t kTerms = CostSample::kTerms;
constexpr double kFarOff = 6; ///< times the median of the distances

double distance(const CostSample& sample, const Coefficients& coefficients) {
    double seconds = 0;
    for (std::size_t term = 0; term < kTerms; ++term)
        seconds += coefficients.at(term) * sample.work.at(term);
    return sample.seconds - seconds;
}

double squares(std::span<const CostSample> samples, const Coefficients& coefficients) {
    double sum = 0;
    for (const CostSample& sample : samples)
        sum += distance(sample, coefficients) * distance(sample, coefficients);
    return sum;
}

/// Solves the normal equations of the terms in `used`; false if they have no unique solution.
bool solve(std::span<const CostSample> samples, unsigned used, const Coefficients& scale, Coefficients& out) {
    glm::dmat3 normal(1.0); // unused terms: x = 0
    glm::dvec3 right(0.0);
    for (int a = 0; a < 3; ++a) {
        if ((used >> a & 1U) == 0)
            continue;
        for (int b = 0; b < 3; ++b)
            normal[b][a] = 0;
        for (const CostSample& sample : samples) {
            const double wa =
                sample.work.at(static_cast<std::size_t>(a)) / scale.at(static_cast<std::size_t>(a));
            right[a] += wa * sample.seconds;
            for (int b = 0; b < 3; ++b)
                if ((used >> b & 1U) != 0)
                    normal[b][a] += wa * sample.work.at(static_cast<std::size_t>(b)) /
                                    scale.at(static_cast<std::size_t>(b));
        }
    }
    const double determinant = glm::determinant(normal);
    if (!(std::abs(determinant) > 1e-9))
        return false;
    const glm::dvec3 solution = glm::inverse(normal) * right;
    for (int term = 0; term < 3; ++term) {
        const auto place = static_cast<std::size_t>(term);
        out.at(place) = (used >> term & 1U) != 0 ? solution[term] / scale.at(place) : 0;
        if (!(out.at(place) >= 0))
            return false;
    }
    return true;
}

Coefficients fitOnce(std::span<const CostSample> samples) {
    Coefficients scale{1, 1, 1}; // so that the equations are independent of units: every term has a mean
                                 // square of 1
    for (std::size_t term = 0; term < kTerms; ++term) {
        double sum = 0;
        for (const CostSample& sample : samples)
            sum += sample.work.at(term) * sample.work.at(term);
        if (sum > 0)
            scale.at(term) = std::sqrt(sum);
    }
    Coefficients best{};
    double least = std::numeric_limits<double>::infinity();
    for (unsigned used = 0; used < 1U << kTerms; ++used) {
        Coefficients candidate{};
        if (!solve(samples, used, scale, candidate))
            continue;
        const double sum = squares(samples, candidate);
        if (sum < least) {
            least = sum;
            best = candidate;
        }
    }
    return best;
}

} // namespace

Coefficients fitCost(std::span<const CostSample> samples) {
    const Coefficients first = fitOnce(samples);
    std::vector<double> distances;
    for (const CostSample& sample : samples)
        distances.push_back(std::abs(distance(sample, first)));
    const double limit = kFarOff * quantile(distances, 0.5);
    std::vector<CostSample> near;
    for (const CostSample& sample : samples)
        if (std::abs(distance(sample, first)) <= limit)
            near.push_back(sample);
    return near.size() > kTerms ? fitOnce(near) : first;
}

void Slowdown::add(std::span<const CostSample> samples, const Coefficients& coefficients) {
    for (const CostSample& sample : samples) {
        measured += sample.seconds;
        fitted += sample.seconds - distance(sample, coefficients);
    }
}

Coefficients scaled(const Coefficients& coefficients, double factor) {
    Coefficients out = coefficients;
    for (double& coefficient : out)
        coefficient *= factor;
    return out;
}

double CostModel::cost(const WorkCount& count, int regionCells) const {
    const auto frames = static_cast<double>(count.frames);
    const auto regions = static_cast<double>(count.regionsShown);
    const auto made = static_cast<double>(count.facesMade);
    double seconds = cutSeconds;
    seconds += drawPerFrameFaceRegion[0] * frames;
    seconds += drawPerFrameFaceRegion[1] * static_cast<double>(count.faces);
    seconds += drawPerFrameFaceRegion[2] * regions;
    seconds += uploadPerFrameFaceRegion[0] * frames;
    seconds += uploadPerFrameFaceRegion[1] * made;
    seconds += uploadPerFrameFaceRegion[2] * regions;
    if (count.moments == 0)
        return seconds;
    const Decimation& fitted = decimation.at(regionCells);
    seconds += fitted.perStartRegion * static_cast<double>(count.startRegions);
    seconds += fitted.perMomentRegionFace[0] * static_cast<double>(count.moments);
    seconds +=
        fitted.perMomentRegionFace[1] * static_cast<double>(count.regionsDecimated - count.startRegions);
    seconds += fitted.perMomentRegionFace[2] * made;
    return seconds;
}

} // namespace proveout
