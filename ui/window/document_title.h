// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "ui/session/session.h"

namespace proveout {

/// "bracket.nc", or what a program without a file is called.
[[nodiscard]] QString documentName(const Session& session);

/// "bracket.nc (bracket.proveout) – Proveout". The mark [*] of QWidget::setWindowTitle() is behind what is
/// not saved: the program, its job, or the setup that is in no job.
[[nodiscard]] QString documentTitle(const Session& session);

} // namespace proveout
