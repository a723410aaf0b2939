// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QMenu>

#include "ui/window/dock_layouts.h"

namespace proveout {

/// The menu of window layouts; stores the chosen one in the settings. Thread: UI.
class LayoutMenu final : public QMenu {
    Q_OBJECT

public:
    explicit LayoutMenu(QWidget* parent);
    [[nodiscard]] const DockLayout& present() const { return *m_present; }
    void retranslate();

signals:
    /// The user wants this layout in its original form, even if it is the current one.
    void chosen(const DockLayout& layout);

private:
    void choose(const DockLayout& layout);

    const DockLayout* m_present;
    std::vector<QAction*> m_actions; ///< same order as dockLayouts()
};

} // namespace proveout
