// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for the program of any text whatever.
#pragma once

#include <string>

#include "core/nc/run/interpreter.h"

namespace proveout::test {

/// The first promise that `program`, interpreted from `text` with `options`, does not keep, as a sentence;
/// empty where it keeps all.
[[nodiscard]] std::string brokenPromise(const NcText& text, const InterpretOptions& options,
                                        const Program& program);

} // namespace proveout::test
