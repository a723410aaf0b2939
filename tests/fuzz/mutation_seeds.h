// SPDX-License-Identifier: GPL-3.0-or-later
// Small valid files of every kind, and the faulty ones of the corpus if it is present. The sequence is the
// same on every machine.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace proveout::test {

using Seeds = std::vector<std::string>;

// `folder`: for files that are written to be read.
[[nodiscard]] Seeds programSeeds(const std::filesystem::path& folder);
[[nodiscard]] Seeds stlSeeds(const std::filesystem::path& folder);
[[nodiscard]] Seeds jobSeeds(const std::filesystem::path& folder);
[[nodiscard]] Seeds toolTableSeeds(const std::filesystem::path& folder);
[[nodiscard]] Seeds outlineSeeds(const std::filesystem::path& folder);
[[nodiscard]] Seeds savedStockSeeds(const std::filesystem::path& folder);
/// The descriptions in saved stocks.
[[nodiscard]] Seeds stockDescriptionSeeds(const std::filesystem::path& folder);
[[nodiscard]] Seeds npySeeds(const std::filesystem::path& folder);
/// Arguments of `simulate`, one per line.
[[nodiscard]] Seeds optionSeeds(const std::filesystem::path& folder);

/// The heights that belong to the description of a stock.
[[nodiscard]] std::string stockHeights();

} // namespace proveout::test
