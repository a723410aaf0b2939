// SPDX-License-Identifier: GPL-3.0-or-later
// What each figure runs and how it draws the results; the two must agree on the points, so they are in one
// place.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/study/figures.h"

namespace proveout {

/// The reference of all figures: an allowance of 0, every triangle from the z-map.
[[nodiscard]] StudyPoint undecimated(const StudySubject& subject);

/// A curve of Fig. 8.
struct RegionCurve {
    int period;
    double allowance;
};
[[nodiscard]] std::vector<RegionCurve> regionCurves(const StudySubject& subject);

/// A curve of the comparison of section 2.
struct MethodCurve {
    std::string label;
    StudyPoint point;
};
[[nodiscard]] std::vector<MethodCurve> methodCurves(const StudySubject& subject, std::size_t blocks);

[[nodiscard]] StudyPoint orderPoint(const StudySubject& subject, RemovalOrder order, int region);
[[nodiscard]] StudyPoint regionPoint(const StudySubject& subject, const RegionCurve& curve, int region);
[[nodiscard]] StudyPoint allowancePoint(const StudySubject& subject, double allowance);
[[nodiscard]] StudyPoint periodPoint(const StudySubject& subject, int period);

[[nodiscard]] Chart methodChart(const StudySubject& subject, std::span<const StudyRun> runs,
                                std::size_t blocks);
[[nodiscard]] Chart orderChart(const StudySubject& subject, std::span<const StudyRun> runs);
[[nodiscard]] Chart regionChart(const StudySubject& subject, std::span<const StudyRun> runs);
[[nodiscard]] Chart allowanceChart(const StudySubject& subject, std::span<const StudyRun> runs);
[[nodiscard]] Chart facesChart(const StudySubject& subject, std::span<const StudyRun> runs);
[[nodiscard]] Chart timesChart(const StudySubject& subject, std::span<const StudyRun> runs);
[[nodiscard]] Chart periodChart(const StudySubject& subject, std::span<const StudyRun> runs);

} // namespace proveout
