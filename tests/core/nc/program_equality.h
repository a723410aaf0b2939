// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/nc/program/program.h"

namespace proveout::test {

/// The first difference between two programs, bit for bit, as a sentence; empty if they are equal.
[[nodiscard]] std::string difference(const Program& a, const Program& b);

} // namespace proveout::test
