// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/diagnostic.h"
#include "core/decimation/regions/parameters.h"

namespace proveout::cli {

/// A file that a command is requested to write. Value type.
struct Output {
    std::string file;        ///< empty: not requested
    std::uint64_t bytes = 0; ///< its size, as far as known at this point
};

/// Called before any work, and again when sizes are known: refuses outputs that would overwrite an input or
/// each other, that cannot be written, or for which there is not enough space, added up per disk. Creates no
/// files, and existing files stay unchanged.
[[nodiscard]] Result<void> checkOutputs(const std::vector<std::string>& inputs,
                                        const std::vector<Output>& outputs);

/// Whether a mesh with these parameters contains all points of the z-map.
[[nodiscard]] bool writesFullMesh(const DecimationParameters& parameters);

/// Refuses parameters that give a surface with cracks.
[[nodiscard]] Result<void> checkExportable(const DecimationParameters& parameters);

} // namespace proveout::cli
