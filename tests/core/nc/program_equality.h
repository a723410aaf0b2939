// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/nc/program/program.h"

namespace proveout::test {

/// The first thing in which two programs differ, bit for bit, as a sentence; empty where they are the same.
[[nodiscard]] std::string difference(const Program& a, const Program& b);

} // namespace proveout::test
