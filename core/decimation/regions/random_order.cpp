// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimation/regions/random_order.h"

#include <utility>

namespace proveout {

namespace {

/// SplitMix64 (Steele, Lea, Flood, OOPSLA 2014): 64 bits of state, every seed is a good one.
std::uint64_t next(std::uint64_t& state) {
    state += 0x9E3779B97F4A7C15U;
    std::uint64_t z = state;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31U);
}

} // namespace

std::uint64_t mixSeed(int seed, std::uint64_t family, std::uint64_t member) {
    std::uint64_t state = static_cast<std::uint64_t>(seed);
    state = next(state) ^ family;
    state = next(state) ^ member;
    return next(state);
}

void arrange(std::span<std::uint32_t> items, RemovalOrder order, std::uint64_t seed) {
    if (order == RemovalOrder::sequential)
        return;
    std::uint64_t state = seed;
    // Fisher–Yates. The index is the high word of 32 random bits times the range: its bias is below 2⁻³² per
    // item, and no value is ever drawn twice.
    for (std::size_t left = items.size(); left > 1; --left) {
        const std::uint64_t pick = ((next(state) >> 32U) * left) >> 32U;
        std::swap(items[left - 1], items[pick]);
    }
}

} // namespace proveout
