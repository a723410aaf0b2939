// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/decimation/regions/parameters.h"

namespace proveout::cli {

/// A file that a command is asked to write. Value type.
struct Output {
    std::string file;        ///< empty: not asked for
    std::uint64_t bytes = 0; ///< that it will take, as far as that is known by now
};

/// Asked before any work, and once more when sizes are known: refuses outputs that would overwrite an input
/// or one another, that cannot be written, and for which there is no space, together where they share a disk.
/// Nothing is left behind, and files that are there stay as they are.
[[nodiscard]] Result<void> checkOutputs(const std::vector<std::string>& inputs,
                                        const std::vector<Output>& outputs);

/// Whether a mesh with these parameters has all points of the map.
[[nodiscard]] bool writesFullMesh(const DecimationParameters& parameters);

/// Refuses parameters whose surface has cracks.
[[nodiscard]] Result<void> checkExportable(const DecimationParameters& parameters);

} // namespace proveout::cli
