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

/// "*.stl", from the row of the format, for the filter of a file dialog.
[[nodiscard]] QString formatPatterns(const FileFormat& format);
/// "STL, binary (*.stl)".
[[nodiscard]] QString formatFilter(const FileFormat& format);

/// Asks for the mesh file to write: one filter a format of the table. Choosing a filter changes the ending;
/// an ending that was typed outranks the filter where it names another mesh format, any other name gets the
/// ending of the filter. Asks before a file is replaced. Nothing where the user cancelled. UI thread.
[[nodiscard]] std::optional<ExportTarget> askForExport(QWidget& parent, const QString& title,
                                                       const QString& proposal);

} // namespace proveout
