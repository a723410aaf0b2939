// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QIcon>
#include <QString>

namespace proveout {

/// The icon `:/icons/<name>.svg`, drawn in `color` or, if that is invalid, in the palette's text colour at
/// the moment of painting, so that it follows the theme. Null if there is no such icon.
[[nodiscard]] QIcon icon(const QString& name, const QColor& color = {});

} // namespace proveout
