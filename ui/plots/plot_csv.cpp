// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_csv.h"

#include <array>
#include <charconv>
#include <cmath>

namespace proveout {
namespace {

/// Appends nothing if the value is unknown.
void append(std::string& text, double value) {
    if (std::isnan(value))
        return;
    std::array<char, 32> digits{};
    // Most values come from floats and counts, which are read back exactly from nine digits.
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 9);
    text.append(digits.data(), end.ptr);
}

void appendPicture(std::string& text, const PictureBlocks& picture) {
    text += ',';
    if (picture.first < picture.last)
        append(text, picture.first + 1.0);
    text += ',';
    if (picture.first < picture.last)
        append(text, picture.last);
}

} // namespace

std::string plotCsv(const PlotSpec& plot, const PlotInput& input) {
    std::string text = "block";
    for (const PlotSeries& series : plot.series)
        text.append(",").append(series.key);
    if (plot.picture != nullptr)
        text += ",pictureFirstBlock,pictureLastBlock";
    text += '\n';
    for (std::size_t row = 0; row < input.blocks.size(); ++row) {
        append(text, static_cast<double>(row + 1));
        for (std::size_t series = 0; series < plot.series.size(); ++series) {
            text += ',';
            append(text, plot.y(input, row, series));
        }
        if (plot.picture != nullptr)
            appendPicture(text, plot.picture(input, row));
        text += '\n';
    }
    return text;
}

} // namespace proveout
