// SPDX-License-Identifier: GPL-3.0-or-later
// A race between tasks, which ThreadSanitizer must report: otherwise it checks no parallel loop.
#include <cstdio>
#include <vector>

#include "core/base/parallel.h"

int main() {
    constexpr int kRounds =
        200; // ends at the first report; on a busy machine one thread may do a round alone
    std::vector<double> values(100'000, 1);
    double sum = 0;
    for (int round = 0; round < kRounds; ++round) {
        proveout::inParallel(values.size(), [&](std::size_t k) {
            for (int step = 0; step < 50; ++step)
                values[k] *= 1.000'000'1;
            sum += values[k];
        });
    }
    std::printf("%g\n", sum);
    return 0;
}
