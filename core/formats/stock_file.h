// SPDX-License-Identifier: GPL-3.0-or-later
// A stock as an earlier set-up has left it, in one file: a ZIP archive of `stock.json`, which says what it
// is, and `heights.npy`, the heights over its top to the last bit; NumPy reads it by numpy.load().
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/base/diagnostic.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// Where a stock comes from.
struct StockProvenance {
    std::string program;      ///< the file name of the program that has cut it, without folders
    std::uint64_t blocks = 0; ///< moving blocks executed
    std::uint32_t line = 0;   ///< of the last of them
    bool finished = false;    ///< the program was through

    friend bool operator==(const StockProvenance&, const StockProvenance&) = default;
};

struct SavedStockFile {
    ZMapSnapshot zmap;
    double spacing = 1; ///< that its grid was made with
    StockProvenance provenance;
};

/// Writes a stock atomically; equal stocks give equal files. `spacing`: the one wanted of its grid. Errors:
/// the file cannot be written, or the name of the program is not UTF-8.
[[nodiscard]] Result<void> writeStock(const std::filesystem::path& file, const ZMapSnapshot& zmap,
                                      double spacing, const StockProvenance& provenance);

/// Reads it back. What the file says of its size is checked against the memory that may be taken, and against
/// what is in the file, before anything is. Errors: unreadable, no such file, written by a newer Proveout,
/// cut off, checksums, sizes that do not fit each other, heights that are no numbers or not within the stock.
[[nodiscard]] Result<SavedStockFile> readStock(const std::filesystem::path& file);

} // namespace proveout
