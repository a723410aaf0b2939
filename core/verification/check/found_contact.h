// SPDX-License-Identifier: GPL-3.0-or-later
// Where the tool of a finding is in the moment that the finding is about, for a view that shows it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "core/cutter/tool_part.h"
#include "core/nc/program/program.h"
#include "core/simulation/setup/setup.h"
#include "core/verification/check/check_report.h"

namespace proveout {

/// Value type; program coordinates, mm.
struct FoundContact {
    std::size_t block = 0; ///< 0-based: the one of the largest value
    Vec3 tip{0};           ///< of the tool
    Vec3 place{0};         ///< what is to be looked at
    double size = 0;       ///< the radius of the part of the tool there
    ToolPart part = ToolPart::flutes;
    std::string fixture = {}; ///< its name; empty: something else is touched

    friend bool operator==(const FoundContact&, const FoundContact&) = default;
};

/// Nothing if the finding is not about a contact of a tool, or the tool is unknown. The program and the setup
/// must be those of the finding. Any thread.
[[nodiscard]] std::optional<FoundContact> contactOf(const CheckFinding& finding, const Program& program,
                                                    const Setup& setup);

} // namespace proveout
