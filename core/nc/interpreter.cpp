// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/interpreter.h"

#include "core/nc/interpretation.h"

namespace proveout {

std::shared_ptr<const Program> interpret(const NcText& text, const InterpretOptions& options,
                                         const WorkContext& context) {
    return Interpretation(text, options, context).run();
}

} // namespace proveout
