// SPDX-License-Identifier: GPL-3.0-or-later
// Subprograms by number: M98 and M99.
#include <cmath>
#include <fmt/format.h>
#include <string>

#include "core/nc/codes/handlers.h"
#include "core/nc/state/execution.h"

namespace proveout {

namespace {

constexpr double kMostNumber = 1e8;
constexpr double kMostRuns = 1e9;

bool whole(const Word& word, double most) {
    return word.value >= 0 && word.value <= most && word.value == std::round(word.value);
}

} // namespace

void callProgram(Execution& execution, const Word& word) {
    const Block& block = execution.block;
    if (!block.has('P')) {
        execution.reporter.report(nc_message::kWordMissing, word, {"M98", "P"});
        return;
    }
    FlowRequest request{FlowRequest::Kind::call, 0, 1, block.word('P')};
    // On Mach, Q is among the words of this code.
    const char repeats = block.has('L') ? 'L' : 'Q';
    for (const char letter : {'P', repeats}) {
        const double most = letter == 'P' ? kMostNumber : kMostRuns;
        if (block.has(letter) && !whole(block.word(letter), most)) {
            execution.reporter.report(nc_message::kNotInteger, block.word(letter),
                                      {std::string(1, letter), "0", fmt::format("{:.0f}", most)});
            return;
        }
    }
    if (repeats == 'L' && block.has('Q'))
        execution.reporter.report(nc_message::kWordIgnored, block.word('Q'), {"Q"});
    request.program = static_cast<int>(block.value('P'));
    request.repeats = block.has(repeats) ? static_cast<int>(block.value(repeats)) : 1;
    if (request.repeats == 0 && execution.dialect.entersUncalled)
        execution.reporter.report(nc_message::kCalledNever, block.word(repeats));
    execution.request = request;
}

void returnFromProgram(Execution& execution, const Word& word) {
    execution.request = {FlowRequest::Kind::returns, 0, 1, word};
}

} // namespace proveout
