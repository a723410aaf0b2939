// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QWidget;

namespace proveout {

/// Asks for the name of a file to write. The dialog adds `suffix` to a name without an extension (without a
/// dot; empty: names stay unchanged), so that its overwrite question is about the file that will be written.
/// Empty if the user cancels. UI thread; returns when the dialog is closed.
[[nodiscard]] QString askWhereToSave(QWidget& parent, const QString& title, const QString& proposal,
                                     const QString& filter, const QString& suffix = {});

} // namespace proveout
