// SPDX-License-Identifier: GPL-3.0-or-later
// A chart as a value: the content of a figure of the paper, independent of how it is drawn.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/geometry.h"

namespace proveout {

enum class CurveLook : std::uint8_t {
    marked, ///< a few points: a line with a marker at each
    plain,  ///< many points: a line
    faint,  ///< many points behind a curve that summarizes them
    level,  ///< a dashed line with which the others are compared
};

/// Curves of one colour belong together; dash and marker follow the colour, so that curves can be
/// distinguished without it.
struct Curve {
    std::string label;
    CurveLook look = CurveLook::marked;
    int colour = 0;
    bool rightAxis = false;
    std::vector<Vec2> points;
    bool inLegend = true;
};

struct Chart {
    std::string id; ///< file name without its extension
    std::string title;
    std::string subtitle; ///< the parameters that were held fixed
    std::string xLabel;
    std::string yLabel;
    std::string rightLabel; ///< empty: there is no right axis
    bool logarithmicX = false;
    double topOfLeft = 0; ///< the upper limit of the left axis; 0: the highest point
    std::vector<Curve> curves;
};

} // namespace proveout
