// SPDX-License-Identifier: GPL-3.0-or-later
// A race between tasks, which ThreadSanitizer must report: otherwise it checks no parallel loop.
#include <cstdio>
#include <vector>

#include "core/base/parallel.h"

int main() {
    std::vector<double> values(100'000, 1);
    double sum = 0;
    proveout::inParallel(values.size(), [&](std::size_t k) {
        for (int round = 0; round < 50; ++round)
            values[k] *= 1.000'001;
        sum += values[k];
    });
    std::printf("%g\n", sum);
    return 0;
}
