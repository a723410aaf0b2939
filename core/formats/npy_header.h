// SPDX-License-Identifier: GPL-3.0-or-later
// The header of an NPY file: a magic string, a version, and a Python dictionary as text (NumPy's
// numpy.lib.format: "descr", "fortran_order", "shape").
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostic.h"

namespace proveout {

struct NpyHeader {
    std::string type; ///< "descr", e.g. "<f4"
    bool fortranOrder = false;
    std::vector<std::uint64_t> shape;
    std::size_t dataStart = 0; ///< offset of the first value
};

/// Reads the header at the start of `bytes`. Errors: not an NPY file, unknown version, truncated, a
/// dictionary that is not NumPy's.
[[nodiscard]] Result<NpyHeader> readNpyHeader(std::string_view bytes);

/// A version 1 header for values of `type` in C order, padded so that the values start at a multiple of 64.
[[nodiscard]] std::string npyHeader(int rows, int columns, std::string_view type);

} // namespace proveout
