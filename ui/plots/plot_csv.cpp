// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_csv.h"

#include <array>
#include <charconv>
#include <cmath>

namespace proveout {
namespace {

/// Nothing where the value is not known.
void append(std::string& text, double value) {
    if (std::isnan(value))
        return;
    std::array<char, 32> digits{};
    // Most values come from floats and counts, which nine digits give back.
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 9);
    text.append(digits.data(), end.ptr);
}

} // namespace

std::string plotCsv(const PlotSpec& plot, const PlotInput& input) {
    const bool ranges = plot.rows == PlotRows::frames;
    std::string text = ranges ? "firstBlock,lastBlock" : "block";
    for (const PlotSeries& series : plot.series)
        text.append(",").append(series.key);
    text += '\n';
    for (std::size_t row = 0; row < rowCount(plot, input); ++row) {
        if (ranges) {
            append(text, plot.begin(input, row) + 1);
            text += ',';
        }
        append(text, plot.x(input, row));
        for (std::size_t series = 0; series < plot.series.size(); ++series) {
            text += ',';
            append(text, plot.y(input, row, series));
        }
        text += '\n';
    }
    return text;
}

} // namespace proveout
