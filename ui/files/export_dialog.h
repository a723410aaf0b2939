// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QString>
#include <QWidget>

#include "core/formats/formats.h"

namespace proveout {

struct ExportTarget {
    QString file;
    const FileFormat* format = nullptr;
};

/// "*.stl": the extensions of the format, for the filter of a file dialog.
[[nodiscard]] QString formatPatterns(const FileFormat& format);
/// "STL, binary (*.stl)".
[[nodiscard]] QString formatFilter(const FileFormat& format);

/// Asks for the mesh file to write, with one filter per format of the table. Choosing a filter changes the
/// extension. A typed extension overrides the filter if it names another mesh format; any other name gets the
/// extension of the filter. Asks before a file is replaced. Empty if the user cancelled. UI thread.
[[nodiscard]] std::optional<ExportTarget> askForExport(QWidget& parent, const QString& title,
                                                       const QString& proposal);

} // namespace proveout
