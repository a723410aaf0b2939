// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>

#include "core/nc/program/motion.h"

namespace proveout::test {

/// A random arc motion in any plane, up to three turns, with or without a rise, whose radius grows by up to
/// the factor `growth`.
Motion randomArc(std::mt19937& random, double growth);

double uniform(std::mt19937& random, double from, double to);

} // namespace proveout::test
