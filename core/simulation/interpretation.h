// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>

#include "core/nc/interpreter.h"
#include "core/simulation/setup.h"

namespace proveout {

/// What a control knows of the cutters of a table: their diameters. Their lengths are taken to be
/// compensated, so that programs position the tip.
[[nodiscard]] ToolOffsets toolOffsets(const ToolTable& tools);

/// What the motions of a program may take: half of the memory that a job may have, because they take as much
/// again while they grow. Rounded, because the memory that is free changes all the time.
[[nodiscard]] std::uint64_t programBytesThatFit();

/// How a program is interpreted on a set-up, whose stock its probing motions meet. `file` is where it lies,
/// and names it in messages; its subprograms are looked for beside it. Empty where it lies nowhere yet.
/// Its limits are those of the memory.
[[nodiscard]] InterpretOptions interpretOptions(const Setup& setup, const std::filesystem::path& file);

/// Whether a program that was interpreted on one set-up is the same on the other.
[[nodiscard]] bool interpretedAlike(const Program& program, const Setup& one, const Setup& other);

} // namespace proveout
