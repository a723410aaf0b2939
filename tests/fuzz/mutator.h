// SPDX-License-Identifier: GPL-3.0-or-later
// Damages a file as programs, people and disks do, without knowledge of its format.
#pragma once

#include <cstddef>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace proveout::test {

using MutationRandom = std::mt19937_64;

/// Inputs do not grow beyond this, bytes, because seconds for so little input are too long.
inline constexpr std::size_t kLargestInput = 256'000;

/// `seed` with up to nine changes, rarely many: bits, bytes, pieces, numbers, words and separators; `words`
/// are the elements of this kind of file. Depends only on its arguments; equal on every machine.
[[nodiscard]] std::string mutated(std::string seed, std::span<const std::string> words,
                                  MutationRandom& random);

} // namespace proveout::test
