// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>

#include "core/base/persistent_array.h"

namespace proveout {

/// The elements [first, end) of an array; if `first` is `end`, none.
struct ArrayStretch {
    std::size_t first = 0;
    std::size_t end = 0;
};

/// The shortest stretch outside of which two arrays have the same elements, by `same`, a function of two
/// elements; arrays of different size differ up to the end of the longer one. Chunks that both share are not
/// read, so that comparing with an older copy costs only what has changed since, and two addresses per 256
/// elements. Call it on the thread that may read both.
template<class T, class Same>
[[nodiscard]] ArrayStretch difference(const PersistentArray<T>& a, const PersistentArray<T>& b, Same same) {
    constexpr std::size_t kChunk = PersistentArray<T>::kChunkSize;
    const std::size_t common = std::min(a.size(), b.size());
    const auto isShared = [&](std::size_t chunk) { return &a[chunk * kChunk] == &b[chunk * kChunk]; };
    ArrayStretch found{0, std::max(a.size(), b.size())};
    while (found.first < common) {
        const std::size_t chunk = found.first / kChunk;
        if (isShared(chunk))
            found.first = std::min(common, (chunk + 1) * kChunk);
        else if (same(a[found.first], b[found.first]))
            ++found.first;
        else
            break;
    }
    while (a.size() == b.size() && found.end > found.first) {
        const std::size_t chunk = (found.end - 1) / kChunk;
        if (isShared(chunk))
            found.end = std::max(found.first, chunk * kChunk);
        else if (same(a[found.end - 1], b[found.end - 1]))
            --found.end;
        else
            break;
    }
    return found;
}

} // namespace proveout
