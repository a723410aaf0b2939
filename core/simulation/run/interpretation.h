// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "core/nc/run/interpreter.h"
#include "core/simulation/setup/setup.h"

namespace proveout {

/// What a control knows of the cutters of a table: their diameters. Their lengths are taken to be
/// compensated, so that programs position the tip.
[[nodiscard]] ToolOffsets toolOffsets(const ToolTable& tools);

/// What the motions of a program may take: half of the memory that a job may have, because they take as much
/// again while they grow. Rounded, because the memory that is free changes all the time.
[[nodiscard]] std::uint64_t programBytesThatFit();

/// Sets what eachControlField() names.
void setControl(const Setup& setup, InterpretOptions& options);

/// How a program is interpreted on a set-up, whose stock its probing motions meet. `file` is where it lies,
/// and names it in messages; its subprograms are looked for beside it. Empty where it lies nowhere yet.
/// Its limits are those of the memory.
[[nodiscard]] InterpretOptions interpretOptions(const Setup& setup, const std::filesystem::path& file);

/// The same for looking once more at what `program` does, which was interpreted on that set-up: with the tool
/// that is assumed to be in the spindle, where it was interpreted so.
[[nodiscard]] InterpretOptions interpretOptions(const Setup& setup, const std::filesystem::path& file,
                                                const Program& program);

/// The tool that is assumed to be in the spindle (assumedTool()) where `program` has asked the control for
/// the sizes of a tool: without them G41 does not compensate.
[[nodiscard]] std::optional<int> toolToInterpretWith(const Program& program, const ToolTable& tools);

using InterpretAgain = std::function<std::shared_ptr<const Program>(const InterpretOptions&)>;
/// `program` was interpreted by `options` on a set-up that does not say which tool is in the spindle, and
/// is given back, unless it has to be interpreted `again` with the assumed one.
[[nodiscard]] std::shared_ptr<const Program> withAssumedTool(std::shared_ptr<const Program> program,
                                                             const InterpretOptions& options,
                                                             const ToolTable& tools,
                                                             const InterpretAgain& again);

/// Interprets a text by options of interpretOptions(), with the assumed tool where it takes one.
[[nodiscard]] std::shared_ptr<const Program> interpretOn(const Setup& setup, const NcText& text,
                                                         const InterpretOptions& options);

/// Whether a program that was interpreted on one set-up is the same on the other.
[[nodiscard]] bool interpretedAlike(const Program& program, const Setup& one, const Setup& other);

} // namespace proveout
