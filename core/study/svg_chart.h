// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/study/chart.h"

namespace proveout {

inline constexpr int kChartWidth = 900;
inline constexpr int kChartHeight = 540;

/// The chart as an SVG document (UTF-8), dark on white, without style sheet or script, so that every viewer
/// shows it the same way. Letters keep their size in a small picture; a low one has no title. Curves with
/// more points than the picture has columns keep the lowest and the highest of each column. Points that are
/// not finite are omitted. Pure function.
[[nodiscard]] std::string svgChart(const Chart& chart, int width = kChartWidth, int height = kChartHeight);

} // namespace proveout
