// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "core/base/diagnostic.h"

namespace proveout {

/// A two-dimensional NumPy array: shape (rows, columns), C order.
struct NpyArray {
    int rows = 0;
    int columns = 0;
    std::vector<double> values;
};

/// Reads little-endian float32 or float64, C order, two dimensions, format versions 1 to 3; anything else is
/// an error that names it. Every value must be finite and within the range of float32, because these arrays
/// are heights.
[[nodiscard]] Result<NpyArray> readNpy(const std::filesystem::path& file);

/// Writes float32, atomically. `fill(row, values)` is called once per row, in ascending order, so that the
/// array need not be in memory.
[[nodiscard]] Result<void> writeNpy(const std::filesystem::path& file, int rows, int columns,
                                    const std::function<void(int, std::span<float>)>& fill);

/// The same for unsigned 32-bit integers.
[[nodiscard]] Result<void> writeNpy(const std::filesystem::path& file, int rows, int columns,
                                    const std::function<void(int, std::span<std::uint32_t>)>& fill);

/// Writes float32, atomically. `values` must be rows × columns.
[[nodiscard]] Result<void> writeNpy(const std::filesystem::path& file, const NpyArray& array);

} // namespace proveout
