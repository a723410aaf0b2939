// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QMenu>

#include "ui/window/dock_layouts.h"

namespace proveout {

/// The arrangements of the window to choose from; keeps the chosen one in the settings. Thread: UI.
class LayoutMenu final : public QMenu {
    Q_OBJECT

public:
    explicit LayoutMenu(QWidget* parent);
    [[nodiscard]] const DockLayout& present() const { return *m_present; }
    void retranslate();

signals:
    /// The user wants this layout, from its beginning, also where it is the present one.
    void chosen(const DockLayout& layout);

private:
    void choose(const DockLayout& layout);

    const DockLayout* m_present;
    std::vector<QAction*> m_actions; ///< in the order of dockLayouts()
};

} // namespace proveout
