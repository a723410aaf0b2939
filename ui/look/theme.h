// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>
#include <QString>

#include "core/base/diagnostic.h"

namespace proveout {

enum class Theme { system, light, dark };

/// The palettes of the product. Texts have a contrast of at least 4.5 : 1 on what they stand on.
[[nodiscard]] QPalette lightPalette();
[[nodiscard]] QPalette darkPalette();

/// Colours with a meaning; each has 3 : 1 (WCAG's figure for graphics) on the palette's base at least.
struct MeaningColors {
    QColor error;
    QColor warning;
    QColor note;
    QColor accent; ///< the current block, the play head
    QColor toolChange;
    QColor word;       ///< G and M words
    QColor coordinate; ///< axis words
    QColor comment;
    QColor breakpoint;
    QColor cutting; ///< stretches of the program that cut; air and rapids are lighter, or darker on dark
    QColor air;     ///< that go through air at feed
};
[[nodiscard]] MeaningColors meaningColors(const QPalette& palette);
[[nodiscard]] QColor severityColor(const MeaningColors& colors, Severity severity);

[[nodiscard]] bool isDark(const QPalette& palette);
/// WCAG contrast of two opaque colours, 1 … 21.
[[nodiscard]] double contrast(const QColor& a, const QColor& b);

/// Sets style and palette of the application. The first call must come before any other palette is set: it
/// notes whether the system is dark.
void applyTheme(Theme theme);

/// "system", "light", "dark" in settings and on the command line; system where the key is unknown.
[[nodiscard]] QString themeKey(Theme theme);
[[nodiscard]] Theme themeFromKey(const QString& key);

} // namespace proveout
