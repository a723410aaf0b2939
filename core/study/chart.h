// SPDX-License-Identifier: GPL-3.0-or-later
// A chart as a value: what a figure of the paper shows, whoever draws it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/geometry.h"

namespace proveout {

enum class CurveLook : std::uint8_t {
    marked, ///< a few points: a line with a marker at each
    plain,  ///< many points: a line
    faint,  ///< many points behind a curve that sums them up
    level,  ///< a dashed line, for what the others are compared with
};

/// Curves of one colour belong together; dash and marker follow the colour, so that none is told by it alone.
struct Curve {
    std::string label;
    CurveLook look = CurveLook::marked;
    int colour = 0;
    bool rightAxis = false;
    std::vector<Vec2> points;
    bool inLegend = true;
};

struct Chart {
    std::string id; ///< file name without its ending
    std::string title;
    std::string subtitle; ///< what was held fixed
    std::string xLabel;
    std::string yLabel;
    std::string rightLabel; ///< empty: no right axis
    bool logarithmicX = false;
    double topOfLeft = 0; ///< where the left axis ends at most; 0: at the highest point
    std::vector<Curve> curves;
};

} // namespace proveout
