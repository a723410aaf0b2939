// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <string>
#include <vector>

#include "core/nc/geometry/compensation.h"

namespace proveout::test {

struct RandomPathShape {
    int paths = 8;
    double shortest = 2; ///< mm
    double longest = 40;
    double sharpestTurn = 3.1; ///< angle between two paths, rad
    double flattestTurn = 0;
    double smallestRadius = 2;
    double longestSweep = 4.5; ///< rad
    bool lines = false;        ///< no arcs
};

/// Consecutive lines and arcs with corners of any kind, from the origin. The first is a line.
std::vector<PlanePath> randomPath(std::mt19937& random, const RandomPathShape& shape);

/// The words of a motion along a path in the XY plane, with nine decimals.
std::string wordsOf(const PlanePath& path);

/// The path with end and centre rounded as in its words.
PlanePath rounded(PlanePath path);

} // namespace proveout::test
