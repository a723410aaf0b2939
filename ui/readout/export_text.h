// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>

#include "ui/program/export_job.h"

namespace proveout {

/// The error of the written file, and whether it is certified or only measured. One line, however long the
/// file name is.
[[nodiscard]] QString exportText(const ExportSummary& summary, const QLocale& locale);
/// The path and the size of the file.
[[nodiscard]] QString exportDetails(const ExportSummary& summary, const QLocale& locale);

} // namespace proveout
