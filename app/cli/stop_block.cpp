// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/stop_block.h"

#include <algorithm>
#include <charconv>

namespace proveout::cli {

std::optional<StopBlock> parseStopBlock(const std::string& text) {
    StopBlock stop;
    const char* first = text.data();
    const char* const last = first + text.size();
    if (!text.empty() && (text.front() == 'L' || text.front() == 'l')) {
        stop.isLine = true;
        ++first;
    }
    const auto [end, error] = std::from_chars(first, last, stop.number);
    if (error != std::errc{} || end != last)
        return std::nullopt;
    return stop;
}

std::size_t blocksToRun(const std::optional<StopBlock>& stop, const Program& program) {
    if (!stop)
        return program.blockCount();
    if (stop->isLine)
        return program.blocksAfterLine(stop->number);
    return std::min<std::size_t>(stop->number, program.blockCount());
}

} // namespace proveout::cli
