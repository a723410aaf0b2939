// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include <QString>

class QWidget;

namespace proveout {

/// Asks whether a job may read files outside its folder. UI thread; returns when the user has answered.
[[nodiscard]] bool mayReadOutside(QWidget& parent, const QString& jobFile,
                                  const std::vector<std::filesystem::path>& files);

} // namespace proveout
