// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>

#include "ui/program/export_job.h"

namespace proveout {

/// The error of the file that was written, and what that figure is worth: certified, or only measured. One
/// line, whatever the name of the file.
[[nodiscard]] QString exportText(const ExportSummary& summary, const QLocale& locale);
/// Where the file lies, and how large it is.
[[nodiscard]] QString exportDetails(const ExportSummary& summary, const QLocale& locale);

} // namespace proveout
