// SPDX-License-Identifier: GPL-3.0-or-later
// Paths are passed between Qt and the core as bytes, so that any file name is preserved.
#pragma once

#include <filesystem>

#include <QFile>
#include <QString>

namespace proveout {

[[nodiscard]] inline std::filesystem::path toPath(const QString& file) {
    return {QFile::encodeName(file).toStdString()};
}

[[nodiscard]] inline QString toQString(const std::filesystem::path& file) {
    return QFile::decodeName(QByteArray::fromStdString(file.string()));
}

} // namespace proveout
