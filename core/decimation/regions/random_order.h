// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which vertices are tested for removal (paper §4.3.3). It has its own generator and shuffle:
// those of the standard library may differ between implementations, and so would every mesh.
#pragma once

#include <cstdint>
#include <span>

#include "core/decimation/regions/parameters.h"

namespace proveout {

/// A separate seed for each member of a family (borders, regions), derived from the seed of the parameters.
[[nodiscard]] std::uint64_t mixSeed(int seed, std::uint64_t family, std::uint64_t member);

/// Permutes `items`: at random by `seed`, or not for RemovalOrder::sequential.
void arrange(std::span<std::uint32_t> items, RemovalOrder order, std::uint64_t seed);

} // namespace proveout
