// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/state/execution.h"

#include <cmath>
#include <fmt/format.h>
#include <string>

#include "core/nc/text/messages.h"

namespace proveout {

std::optional<int> wholeNumber(Execution& execution, const Word& word, int least, int most) {
    constexpr double kWhole = 1e-4;
    const double whole = std::round(word.value);
    if (std::abs(word.value - whole) < kWhole && whole >= least && whole <= most)
        return static_cast<int>(whole);
    execution.reporter.report(nc_message::kNotInteger, word,
                              {std::string(1, word.letter), std::to_string(least), std::to_string(most)});
    return {};
}

bool Execution::mayMake(double motions, const Word& word) const {
    if (motions <= static_cast<double>(kMostBlockMotions))
        return true;
    reporter.report(nc_message::kBlockTooLong, word,
                    {fmt::format("{:.15g}", motions), std::to_string(kMostBlockMotions)});
    return false;
}

Execution Execution::at(const Block& other) const {
    return {dialect,  codes, other,   state,   parameters, tools,  registers, request, program,
            reporter, saves, splines, nullptr, target,     limits, callLevel, line};
}

} // namespace proveout
