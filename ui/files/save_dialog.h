// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QWidget;

namespace proveout {

/// Asks for the name of a file to write. The dialog itself completes a name that has no ending by `suffix`
/// (without a dot; empty: names stay as they are), so that its question before an overwrite is about the file
/// that will be written. Empty where the user cancels. UI thread; returns when the dialog is closed.
[[nodiscard]] QString askWhereToSave(QWidget& parent, const QString& title, const QString& proposal,
                                     const QString& filter, const QString& suffix = {});

} // namespace proveout
