// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <string>

namespace proveout {

/// Damages a file as a faulty cable or a full disk would: flips one bit or removes the end.
inline std::string damaged(std::string bytes, std::mt19937& random) {
    if (bytes.empty())
        return bytes;
    const auto at = static_cast<std::size_t>(random()) % bytes.size();
    if (random() % 4 == 0)
        bytes.resize(at);
    else
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
    return bytes;
}

} // namespace proveout
