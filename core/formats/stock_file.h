// SPDX-License-Identifier: GPL-3.0-or-later
// A stock as an earlier setup has left it, in one file: a ZIP archive of `stock.json`, which describes it,
// and `heights.npy`, the heights relative to its top to the last bit; NumPy reads it by numpy.load(). If the
// map has rims, `rims.npy` follows (stock_rims.h), and an older Proveout refuses the file as a newer format.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "core/base/diagnostic.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// Where a stock comes from.
struct StockProvenance {
    std::string program;      ///< the file name, without folders, of the program that has cut it
    std::uint64_t blocks = 0; ///< number of motion blocks executed
    std::uint32_t line = 0;   ///< of the last of these blocks
    bool finished = false;    ///< whether the program was executed to its end

    friend bool operator==(const StockProvenance&, const StockProvenance&) = default;
};

struct SavedStockFile {
    ZMapSnapshot zmap;
    double spacing = 1; ///< with which its grid was made
    StockProvenance provenance;
};

/// Writes a stock atomically; equal stocks give equal files. `spacing`: the requested spacing of its grid.
/// Errors: the file cannot be written, or the name of the program is not UTF-8.
[[nodiscard]] Result<void> writeStock(const std::filesystem::path& file, const ZMapSnapshot& zmap,
                                      double spacing, const StockProvenance& provenance);

/// Reads it back. The size stated in the file is checked against the memory that may be allocated, and
/// against the contents of the file, before anything is allocated. Errors: unreadable, not such a file,
/// written by a newer Proveout, truncated, checksums, sizes that do not fit each other, heights that are not
/// numbers or not within the stock, rims that are not in order, on edges of the grid and within the stock.
[[nodiscard]] Result<SavedStockFile> readStock(const std::filesystem::path& file);

} // namespace proveout
