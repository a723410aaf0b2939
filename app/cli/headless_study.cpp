// SPDX-License-Identifier: GPL-3.0-or-later
// study without a renderer: counts, cutting and decimation are measured; drawing is computed from a given
// rate.
#include "app/cli/study_command.h"

namespace proveout::cli {

void addHeadlessStudyCommand(CLI::App& app, ExitCode& exitCode) {
    addStudyCommand(app, exitCode, {});
}

} // namespace proveout::cli
