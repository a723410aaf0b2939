// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QString>

namespace proveout {

/// The icon `:/icons/<name>.svg`, drawn in the text colour of the palette at the moment of painting, so that
/// it follows the theme. Null where there is no such icon.
[[nodiscard]] QIcon icon(const QString& name);

} // namespace proveout
