// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "ui/document/job_document.h"

class QWidget;

namespace proveout {

enum class SaveAnswer : std::uint8_t { cancel, overwrite, keepBoth };

/// Asks what to do with a file that is newer on disk than in the window. The user can compare the versions
/// before answering. UI thread; returns when the user has answered.
[[nodiscard]] SaveAnswer askBeforeSave(QWidget& parent, const DiskConflict& conflict);

/// Whether a part may be written to `file`: asks if that is the file of the stock in use. UI thread; returns
/// when the user has answered.
[[nodiscard]] bool mayReplaceStock(QWidget& parent, const StockShape& stock, const QString& file);

} // namespace proveout
