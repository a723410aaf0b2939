// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "ui/session/session.h"

namespace proveout {

/// "bracket.nc", or the name of a program without a file.
[[nodiscard]] QString documentName(const Session& session);

/// "bracket.nc (bracket.proveout) – Proveout". The placeholder [*] of QWidget::setWindowTitle() follows what
/// has unsaved changes: the program, its job, or the setup that is in no job.
[[nodiscard]] QString documentTitle(const Session& session);

} // namespace proveout
