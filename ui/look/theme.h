// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>
#include <QString>

#include "core/base/diagnostic.h"

namespace proveout {

enum class Theme { system, light, dark };

/// The palettes of the product. Text has a contrast of at least 4.5 : 1 against its background.
[[nodiscard]] QPalette lightPalette();
[[nodiscard]] QPalette darkPalette();

/// Colours with a meaning; each has a contrast of at least 3 : 1 (WCAG's requirement for graphics) against
/// the palette's base.
struct MeaningColors {
    QColor error;
    QColor warning;
    QColor note;
    QColor accent; ///< the current block and its marker
    QColor toolChange;
    QColor word;       ///< G and M words
    QColor coordinate; ///< axis words
    QColor comment;
    QColor breakpoint;
    QColor cutting; ///< parts of the program that cut; air cuts and rapids are lighter, or darker in the dark
                    ///< theme
    QColor air;     ///< air cuts at feed rate
    QColor safe;    ///< checked, and nothing was found
};
[[nodiscard]] MeaningColors meaningColors(const QPalette& palette);
[[nodiscard]] QColor severityColor(const MeaningColors& colors, Severity severity);

[[nodiscard]] bool isDark(const QPalette& palette);
/// WCAG contrast of two opaque colours, 1 … 21.
[[nodiscard]] double contrast(const QColor& a, const QColor& b);

/// Sets style and palette of the application. The first call must come before any other palette is set,
/// because it determines whether the system theme is dark.
void applyTheme(Theme theme);

/// "system", "light" or "dark", in the settings and on the command line; an unknown key means system.
[[nodiscard]] QString themeKey(Theme theme);
[[nodiscard]] Theme themeFromKey(const QString& key);

} // namespace proveout
