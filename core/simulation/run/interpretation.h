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

/// What a control knows about the cutters of a table: their diameters. Their lengths are assumed to be
/// compensated, so that programs position the tip.
[[nodiscard]] ToolOffsets toolOffsets(const ToolTable& tools);

/// The memory that the motions of a program may use: half of what a job may have, because they need as much
/// again while they grow. Rounded, because the amount of free memory changes all the time.
[[nodiscard]] std::uint64_t programBytesThatFit();

/// Sets the fields that eachControlField() visits.
void setControl(const Setup& setup, InterpretOptions& options);

/// The options for interpreting a program with a setup, whose stock its probing motions touch. `file` is the
/// location of the program, and names it in messages; subprograms are searched for beside it. Empty if
/// the program has no file yet. Its motions may use programBytesThatFit().
[[nodiscard]] InterpretOptions interpretOptions(const Setup& setup, const std::filesystem::path& file);

/// The same for interpreting `program` again, which was interpreted with that setup: with the tool assumed to
/// be in the spindle if it was interpreted that way.
[[nodiscard]] InterpretOptions interpretOptions(const Setup& setup, const std::filesystem::path& file,
                                                const Program& program);

/// The tool assumed to be in the spindle (assumedTool()) if `program` has read the sizes of a tool from the
/// control: without them G41 does not compensate.
[[nodiscard]] std::optional<int> toolToInterpretWith(const Program& program, const ToolTable& tools);

using InterpretAgain = std::function<std::shared_ptr<const Program>(const InterpretOptions&)>;
/// `program` was interpreted by `options` with a setup that does not say which tool is in the spindle. It is
/// returned unless it has to be interpreted `again` with the assumed tool.
[[nodiscard]] std::shared_ptr<const Program> withAssumedTool(std::shared_ptr<const Program> program,
                                                             const InterpretOptions& options,
                                                             const ToolTable& tools,
                                                             const InterpretAgain& again);

/// Interprets a text by options of interpretOptions(), with the assumed tool if the program needs it.
[[nodiscard]] std::shared_ptr<const Program> interpretOn(const Setup& setup, const NcText& text,
                                                         const InterpretOptions& options);

/// Whether a program that was interpreted with one setup is the same with the other.
[[nodiscard]] bool interpretedAlike(const Program& program, const Setup& one, const Setup& other);

} // namespace proveout
