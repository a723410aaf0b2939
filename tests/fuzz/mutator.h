// SPDX-License-Identifier: GPL-3.0-or-later
// Damages a file as programs, people and disks do, without knowing what it is.
#pragma once

#include <cstddef>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace proveout::test {

using MutationRandom = std::mt19937_64;

/// No input grows beyond this, bytes: what takes seconds for so little takes too long.
inline constexpr std::size_t kLargestInput = 256'000;

/// `seed` with up to nine changes, seldom many: bits, bytes, pieces, numbers, words and separators; `words`
/// are what the kind of file is made of. A function of its arguments alone; equal on every machine.
[[nodiscard]] std::string mutated(std::string seed, std::span<const std::string> words,
                                  MutationRandom& random);

} // namespace proveout::test
