// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "ui/document/job_document.h"

class QWidget;

namespace proveout {

enum class SaveAnswer : std::uint8_t { cancel, overwrite, keepBoth };

/// Asks what to do with a file that is newer on the disk than what the window has read. The differences can
/// be looked at before an answer. UI thread; returns when the question is answered.
[[nodiscard]] SaveAnswer askBeforeSave(QWidget& parent, const DiskConflict& conflict);

/// Whether a part may be written to `file`: asks where that is the file of the stock in use. UI thread;
/// returns when the question is answered.
[[nodiscard]] bool mayReplaceStock(QWidget& parent, const StockShape& stock, const QString& file);

} // namespace proveout
