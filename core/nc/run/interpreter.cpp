// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/nc/run/interpreter.h"

#include <utility>

#include "core/nc/run/foreign_text.h"
#include "core/nc/run/interpretation.h"

namespace proveout {

std::shared_ptr<const Program> interpret(const NcText& text, const InterpretOptions& options,
                                         const WorkContext& context, const PublishBeginning& publish) {
    if (auto foreign = foreignProgram(text, options))
        return foreign;
    DialectGuess guess = options.dialect ? DialectGuess{*options.dialect, {}} : guessDialect(text);
    Interpretation run(text, options, std::move(guess), context);
    Beginnings beginnings(publish, options.file);
    run.publish(beginnings);
    return run.run();
}

} // namespace proveout
