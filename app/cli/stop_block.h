// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "core/nc/program/program.h"

namespace proveout::cli {

/// Where `--until` ends the run: after the N-th executed block that moves, or after a source line.
struct StopBlock {
    bool isLine = false;
    std::uint32_t number = 0;
};

/// Reads "N" or "L<n>"; none where it is neither.
[[nodiscard]] std::optional<StopBlock> parseStopBlock(const std::string& text);
/// How many blocks to execute; never more than there are.
[[nodiscard]] std::size_t blocksToRun(const std::optional<StopBlock>& stop, const Program& program);

} // namespace proveout::cli
