// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QActionGroup>
#include <QMenu>
#include <QObject>

#include "ui/look/appearance.h"

namespace proveout {

/// The menus for choosing theme and language; their owner sets the titles. Thread: UI.
class AppearanceMenus final : public QObject {
    Q_OBJECT

public:
    /// `appearance` must outlive this object. The menus belong to the window of `parent`.
    AppearanceMenus(Appearance& appearance, QWidget* parent);
    [[nodiscard]] QMenu& theme() { return *m_theme; }
    [[nodiscard]] QMenu& language() { return *m_language; }
    /// Call it after a change of language or theme.
    void fill();

private:
    void add(QActionGroup& group, const QString& text, bool checked, std::function<void()> choose);

    Appearance& m_appearance;
    QMenu* m_theme;
    QMenu* m_language;
    QActionGroup* m_themes; ///< a child of its menu, like the next one
    QActionGroup* m_languages;
};

} // namespace proveout
