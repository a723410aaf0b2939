// SPDX-License-Identifier: GPL-3.0-or-later
// study without a renderer: counts, cutting and decimation; drawing at a rate that was given.
#include "app/cli/study_command.h"

namespace proveout::cli {

void addHeadlessStudyCommand(CLI::App& app, ExitCode& exitCode) {
    addStudyCommand(app, exitCode, {});
}

} // namespace proveout::cli
