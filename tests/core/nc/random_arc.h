// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>

#include "core/nc/program/motion.h"

namespace proveout::test {

/// A random arc motion: any plane, up to three turns, with or without a rise; a radius that grows by up to
/// `growth` of itself.
Motion randomArc(std::mt19937& random, double growth);

double uniform(std::mt19937& random, double from, double to);

} // namespace proveout::test
