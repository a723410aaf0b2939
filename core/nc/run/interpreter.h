// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/work_context.h"
#include "core/nc/program/probe_target.h"
#include "core/nc/program/program.h"
#include "core/nc/run/beginnings.h"
#include "core/nc/state/tool_offsets.h"
#include "core/nc/text/dialect.h"
#include "core/nc/text/nc_text.h"

namespace proveout {

struct InterpretOptions {
    std::string file; ///< name for diagnostics
    /// Nothing: detected from the text, which is reported.
    std::optional<DialectId> dialect = DialectId::linuxcnc;
    bool lint = true;         ///< also report what is allowed but seldom intended (lint.h)
    bool blockDelete = false; ///< skip blocks that begin with "/"
    /// Cutter compensation of Fanuc and Haas starts and ends around outside corners: type B of Fanuc's
    /// 5003#0, and of Haas's setting 43.
    bool compensationTypeB = false;
    /// Numbers of M codes that move no axis on the machine: ignored if the dialect does not know them.
    std::set<int> ignoredM;
    std::optional<Vec3> start; ///< mm, before the first block; without it the position of every axis is
                               ///< unknown
    int startTool = 0;         ///< in the spindle before the first block; 0: none, or T0
    /// For `interpret`: start at 0,0,0, which is machine zero too; every motion counts as known.
    bool assumeStartAtZero = false;
    /// Of motions, and of events: the block that exceeds it is the last one.
    std::size_t maxMotions = 50'000'000;
    /// The memory for motions, blocks and events (Program::bytes()).
    std::uint64_t maxBytes = 4'000'000'000;
    /// The number of the last motion block, counted from 1: for examining the control after it.
    std::size_t stopAfterBlocks = std::numeric_limits<std::size_t>::max();
    /// A line of the main text, 1-based, whose values are wanted (Program::lineValues): the program ends
    /// after its first execution. 0: none.
    std::uint32_t watchedLine = 0;
    bool watchToEnd = false; ///< continues instead, and counts the executions
    ToolOffsets tools;       ///< lengths and diameters that the control knows
    /// The part that probing motions touch. Without it they are assumed to reach their programmed end, and
    /// what follows is unverified.
    PartToProbe part;
    /// Limits of the lines that run again, in loops and subprograms, together with the motions and events
    /// that they make; and of consecutive ones among those lines without a motion or an event. Ten times the
    /// lines of the text if that is more.
    std::uint64_t maxRepeated = 2'000'000;
    std::uint64_t maxIdle = 1'000'000;
    std::vector<std::filesystem::path> subprogramFolders; ///< for O-word subprograms in separate files
    std::size_t maxDiagnostics =
        100; ///< errors, and others: at least 5; further ones are counted in one last message

    bool operator==(const InterpretOptions&) const = default;
};

/// Interprets an NC text as the control of its dialect does (codes.h). Never fails: what could not be
/// understood is reported in the program's diagnostics, and everything after it is marked unverified. Pure
/// function of text and options; any thread. A stopped context gives the program up to that block with a
/// diagnostic that says so. `publish` receives beginnings of a long program.
[[nodiscard]] std::shared_ptr<const Program> interpret(const NcText& text,
                                                       const InterpretOptions& options = {},
                                                       const WorkContext& context = {},
                                                       const PublishBeginning& publish = {});

} // namespace proveout
