// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/axis_ticks.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace proveout {

namespace {

/// The smallest of 1, 2, 5 times a power of ten that is not below `rough`.
double niceStep(double rough) {
    const double power = std::pow(10, std::floor(std::log10(rough)));
    for (const double digit : {1.0, 2.0, 5.0})
        if (digit * power >= rough * (1 - 1e-9))
            return digit * power;
    return 10 * power;
}

} // namespace

std::string tickLabel(double value, double step) {
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 12);
    const std::string digits = fmt::format("{:.{}f}", std::abs(value), decimals);
    const std::size_t whole = std::min(digits.find('.'), digits.size());
    std::string text(value < 0 ? 1 : 0, '-');
    for (std::size_t place = 0; place < digits.size(); ++place) {
        if (place > 0 && place < whole && (whole - place) % 3 == 0)
            text += ',';
        text += digits[place];
    }
    return text;
}

AxisTicks linearTicks(double lo, double hi, int count) {
    if (!(hi > lo)) { // a single value: some margin on both sides
        const double room = lo == 0 ? 1 : std::abs(lo) / 2;
        lo -= room;
        hi += room;
    }
    const double step = niceStep((hi - lo) / std::max(1, count));
    const auto first = static_cast<long long>(std::floor(lo / step + 1e-9));
    const auto last = static_cast<long long>(std::ceil(hi / step - 1e-9));
    AxisTicks ticks;
    for (long long k = first; k <= last; ++k) {
        ticks.places.push_back(static_cast<double>(k) * step);
        ticks.labels.push_back(tickLabel(ticks.places.back(), step));
    }
    ticks.lo = ticks.places.front();
    ticks.hi = ticks.places.back();
    return ticks;
}

AxisTicks logarithmicTicks(double lo, double hi) {
    if (!(hi > lo)) {
        lo /= 2;
        hi *= 2;
    }
    AxisTicks ticks;
    ticks.lo = lo;
    ticks.hi = hi;
    const bool few = hi / lo > 3e3;
    for (int power = static_cast<int>(std::floor(std::log10(lo))); std::pow(10, power) <= hi; ++power)
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double place = digit * std::pow(10, power);
            if ((few && digit != 1.0) || place < lo * (1 - 1e-9) || place > hi * (1 + 1e-9))
                continue;
            ticks.places.push_back(place);
            ticks.labels.push_back(tickLabel(place, std::pow(10, power)));
        }
    return ticks;
}

} // namespace proveout
