// SPDX-License-Identifier: GPL-3.0-or-later
// M62 to M68: outputs and inputs, which exist only on the machine.
#include <cmath>
#include <fmt/format.h>

#include "core/base/figures_argument.h"
#include "core/nc/codes/handlers.h"
#include "core/nc/state/execution.h"
#include "core/nc/state/machine_values.h"

namespace proveout {

namespace {

constexpr double kMostWait = 4; ///< modes of waiting: at once, rise, fall, high, low

bool given(const Block& block, char letter) {
    return block.has(letter) && block.value(letter) >= 0;
}

bool wordsFit(Execution& execution, const Word& word) {
    const Block& block = execution.block;
    const auto refuse = [&](const FindingRow& message, const Word& where,
                            std::vector<Argument> arguments = {}) {
        execution.reporter.report(message, where, std::move(arguments));
        return false;
    };
    if (block.has('P') && block.has('E'))
        return refuse(nc_message::kInputTwice, block.word('E'));
    if (!given(block, 'P') && !given(block, 'E'))
        return refuse(nc_message::kWordMissing, word, {"M66", "P / E"});
    if (!block.has('L') || block.value('L') == 0)
        return true;
    const Word& wait = block.word('L');
    if (wait.value != std::round(wait.value) || wait.value < 0 || wait.value > kMostWait)
        return refuse(nc_message::kNotInteger, wait, {"L", "0", figures("{:g}", kMostWait)});
    if (block.has('E'))
        return refuse(nc_message::kInputWait, wait);
    if (!block.has('Q') || block.value('Q') <= 0)
        return refuse(nc_message::kWordMissing, word, {"M66", "Q"});
    return true;
}

} // namespace

void waitForInput(Execution& execution, const Word& word) {
    if (!wordsFit(execution, word))
        return;
    // Behaves as LinuxCNC without a machine: the value read before.
    const double before = execution.parameters.numbered(kInputParameter);
    const double value = execution.block.has('P') ? (before != 0 ? 1.0 : 0.0) : before;
    execution.parameters.setNumbered(kInputParameter, value);
    execution.state.inputAssumed = true;
    execution.reporter.report(nc_message::kInputAssumed, word, {figures("{:g}", value)});
}

void switchDigitalOutput(Execution& execution, const Word& word) {
    if (!execution.block.has('P'))
        execution.reporter.report(nc_message::kWordMissing, word, {nameOf(word), "P"});
}

void setAnalogOutput(Execution& execution, const Word& word) {
    if (!given(execution.block, 'E'))
        execution.reporter.report(nc_message::kWordMissing, word, {nameOf(word), "E"});
}

} // namespace proveout
