// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/theme.h"

#include <algorithm>
#include <cmath>

#include <QApplication>
#include <QStyleFactory>

namespace proveout {

namespace {

struct Shades {
    const char* window;
    const char* base;
    const char* alternate;
    const char* text;
    const char* button;
    const char* placeholder;
    const char* highlight;
    const char* link;
    const char* disabled;
    const char* light;
    const char* midlight;
    const char* mid;
    const char* dark;
    const char* shadow;
};

constexpr Shades kLight{"#f1f3f5", "#ffffff", "#f6f8fa", "#1b2026", "#fbfcfd", "#5c6670", "#1f6aa8",
                        "#1a5c96", "#8d96a0", "#ffffff", "#e6e9ec", "#c3c9cf", "#a7aeb6", "#6f7780"};
constexpr Shades kDark{"#24282e", "#1a1d21", "#1f2328", "#e4e7eb", "#2d3239", "#a3adb8", "#2a6fab",
                       "#7fbcf2", "#767f89", "#3c434b", "#343a42", "#15181b", "#121417", "#0b0c0e"};

QPalette paletteOf(const Shades& shades) {
    QPalette palette;
    const auto set = [&](QPalette::ColorRole role, const char* color) {
        palette.setColor(role, QColor(color));
    };
    set(QPalette::Window, shades.window);
    set(QPalette::WindowText, shades.text);
    set(QPalette::Base, shades.base);
    set(QPalette::AlternateBase, shades.alternate);
    set(QPalette::Text, shades.text);
    set(QPalette::Button, shades.button);
    set(QPalette::ButtonText, shades.text);
    set(QPalette::BrightText, "#ffffff");
    set(QPalette::ToolTipBase, shades.base);
    set(QPalette::ToolTipText, shades.text);
    set(QPalette::PlaceholderText, shades.placeholder);
    set(QPalette::Highlight, shades.highlight);
    set(QPalette::HighlightedText, "#ffffff");
    set(QPalette::Link, shades.link);
    set(QPalette::LinkVisited, shades.link);
    set(QPalette::Light, shades.light);
    set(QPalette::Midlight, shades.midlight);
    set(QPalette::Mid, shades.mid);
    set(QPalette::Dark, shades.dark);
    set(QPalette::Shadow, shades.shadow);
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, QColor(shades.disabled));
    return palette;
}

bool systemIsDark() {
    static const bool kDarkAtStart = isDark(QApplication::palette());
    return kDarkAtStart;
}

/// WCAG 2.1: relative luminance.
double luminance(const QColor& color) {
    const auto linear = [](double channel) {
        return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

} // namespace

QPalette lightPalette() {
    return paletteOf(kLight);
}

QPalette darkPalette() {
    return paletteOf(kDark);
}

MeaningColors meaningColors(const QPalette& palette) {
    // The paired colours differ in lightness too, and the views also use shapes, so nothing depends on hue
    // alone.
    if (isDark(palette))
        return {QColor("#ff8a7a"), QColor("#f2c14e"), QColor("#8fb8de"), QColor("#4fa8f0"),
                QColor("#b79cf0"), QColor("#7fc4ff"), QColor("#d7dce2"), QColor("#8fae8b"),
                QColor("#f2668f"), QColor("#4fc4a3"), QColor("#96691a"), QColor("#7ccf8d")};
    return {QColor("#b3261e"), QColor("#8a5a00"), QColor("#2d5d8c"), QColor("#1f6aa8"),
            QColor("#6b46b8"), QColor("#0b5394"), QColor("#1b2026"), QColor("#4a6b46"),
            QColor("#c2185b"), QColor("#00564a"), QColor("#c07d00"), QColor("#1d6b34")};
}

QColor severityColor(const MeaningColors& colors, Severity severity) {
    switch (severity) {
    case Severity::note:
        return colors.note;
    case Severity::warning:
        return colors.warning;
    case Severity::error:
    case Severity::fault:
        return colors.error;
    }
    return colors.error;
}

bool isDark(const QPalette& palette) {
    return luminance(palette.color(QPalette::Window)) < luminance(palette.color(QPalette::WindowText));
}

double contrast(const QColor& a, const QColor& b) {
    const double la = luminance(a);
    const double lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

void applyTheme(Theme theme) {
    const bool system = systemIsDark(); // queried before the application sets its own palette
    const bool dark = theme == Theme::dark || (theme == Theme::system && system);
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QApplication::setPalette(dark ? darkPalette() : lightPalette());
}

QString themeKey(Theme theme) {
    switch (theme) {
    case Theme::system:
        return QStringLiteral("system");
    case Theme::light:
        return QStringLiteral("light");
    case Theme::dark:
        return QStringLiteral("dark");
    }
    return {};
}

Theme themeFromKey(const QString& key) {
    for (const Theme theme : {Theme::light, Theme::dark}) {
        if (themeKey(theme) == key)
            return theme;
    }
    return Theme::system;
}

} // namespace proveout
