// SPDX-License-Identifier: GPL-3.0-or-later
// The table of what is tested with damaged files: one row per kind of input.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "tests/fuzz/mutation_seeds.h"

namespace proveout::test {

struct MutationKind {
    const char* key;
    const char* extension; ///< of its files
    Seeds (*seeds)(const std::filesystem::path& folder);
    std::vector<std::string> (*words)();
    /// Reads and uses the file like the program does. False: it was refused.
    bool (*run)(const std::filesystem::path& file);
};

[[nodiscard]] std::span<const MutationKind> mutationKinds();

} // namespace proveout::test
