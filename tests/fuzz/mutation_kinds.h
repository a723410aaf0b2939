// SPDX-License-Identifier: GPL-3.0-or-later
// The table of what is fed with damaged files: one row a kind of input.
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
    /// Reads the file and does with it what the program does. False: it was refused.
    bool (*run)(const std::filesystem::path& file);
};

[[nodiscard]] std::span<const MutationKind> mutationKinds();

} // namespace proveout::test
