// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/nearest_name.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace proveout {

namespace {

char small(char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

bool sameLetter(char a, char b) {
    return small(a) == small(b);
}

/// Row by row of the usual table: distances of the prefixes of `a` to all prefixes of `b`.
std::size_t distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> beforeLast(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        beforeLast.swap(last);
        last.swap(row);
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t wrong = sameLetter(a[i - 1], b[j - 1]) ? 0 : 1;
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + wrong});
            if (i > 1 && j > 1 && sameLetter(a[i - 1], b[j - 2]) && sameLetter(a[i - 2], b[j - 1]))
                row[j] = std::min(row[j], beforeLast[j - 2] + 1);
        }
    }
    return row.back();
}

} // namespace

std::string_view nearestName(std::string_view word, std::span<const std::string_view> names) {
    std::string_view nearest;
    std::size_t least = word.size();
    for (const std::string_view name : names) {
        const std::size_t longer = std::max(word.size(), name.size());
        const std::size_t limit = longer / 3;
        if (longer - std::min(word.size(), name.size()) > limit) // a text of any length costs nothing
            continue;
        const std::size_t wrong = distance(word, name);
        if (wrong <= limit && wrong < least) {
            nearest = name;
            least = wrong;
        }
    }
    return nearest;
}

} // namespace proveout
