// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace proveout {

using Rgb = std::array<std::uint8_t, 3>;

/// Pixels, row by row from the top. Value type.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<Rgb> pixels;

    [[nodiscard]] Rgb& at(int x, int y) {
        return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
};

/// The bytes of a PNG file. Equal pictures give equal bytes. Throws std::runtime_error if libpng fails.
[[nodiscard]] std::string pngOf(const Picture& picture);

} // namespace proveout
