// SPDX-License-Identifier: GPL-3.0-or-later
// What must hold for the program of any text.
#pragma once

#include <string>

#include "core/nc/run/interpreter.h"

namespace proveout::test {

/// The first guarantee that `program`, interpreted from `text` with `options`, violates, as a sentence; empty
/// if there is none.
[[nodiscard]] std::string brokenPromise(const NcText& text, const InterpretOptions& options,
                                        const Program& program);

} // namespace proveout::test
