// SPDX-License-Identifier: GPL-3.0-or-later
// Small sound files of every kind, and the faulty ones of the corpus where it is present. In an order that is
// the same everywhere.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace proveout::test {

using Seeds = std::vector<std::string>;

// `folder`: for files that are written in order to be read.
[[nodiscard]] Seeds programSeeds(const std::filesystem::path& folder);
[[nodiscard]] Seeds stlSeeds(const std::filesystem::path& folder);
[[nodiscard]] Seeds jobSeeds(const std::filesystem::path& folder);
[[nodiscard]] Seeds toolTableSeeds(const std::filesystem::path& folder);
[[nodiscard]] Seeds outlineSeeds(const std::filesystem::path& folder);
[[nodiscard]] Seeds savedStockSeeds(const std::filesystem::path& folder);
/// What describes the stock in a saved one.
[[nodiscard]] Seeds stockDescriptionSeeds(const std::filesystem::path& folder);
[[nodiscard]] Seeds npySeeds(const std::filesystem::path& folder);
/// Arguments of `simulate`, one a line.
[[nodiscard]] Seeds optionSeeds(const std::filesystem::path& folder);

/// The heights that belong to the description of a stock.
[[nodiscard]] std::string stockHeights();

} // namespace proveout::test
