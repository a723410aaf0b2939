// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "core/nc/program/program.h"

namespace proveout::cli {

/// The end of a run with `--until`: after the N-th executed motion block, or after a source line.
struct StopBlock {
    bool isLine = false;
    std::uint32_t number = 0;
};

/// Parses "N" or "L<n>"; empty if it is neither.
[[nodiscard]] std::optional<StopBlock> parseStopBlock(const std::string& text);
/// The number of blocks to execute, at most the number in the program.
[[nodiscard]] std::size_t blocksToRun(const std::optional<StopBlock>& stop, const Program& program);

} // namespace proveout::cli
