// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include <QDockWidget>
#include <QList>
#include <QObject>

#include "ui/window/panel_table.h"

class QAction;
class QMainWindow;
class QStackedWidget;

namespace proveout {

class FittedDock;
class PanelFocus;

/// The docks of a window: makes one a panel, titles and arranges them and brings them forward. Thread: UI.
class PanelDocks final : public QObject {
    Q_OBJECT

public:
    /// `centre` has the pages in the middle of the window. What the arguments refer to outlives this object;
    /// the docks belong to the window.
    PanelDocks(QMainWindow& window, QStackedWidget& centre, const PanelParts& parts,
               std::span<const PanelRow> rows);

    [[nodiscard]] std::span<const PanelRow> rows() const { return m_rows; }
    /// In the order of the rows.
    [[nodiscard]] const std::vector<QDockWidget*>& all() const { return m_docks; }
    /// The panel of this class; null where there is none.
    template<class Panel>
    [[nodiscard]] Panel* panel() const {
        for (const QDockWidget* dock : m_docks) {
            if (auto* found = qobject_cast<Panel*>(dock->widget()))
                return found;
        }
        return nullptr;
    }
    /// The actions() of the panels that have theirs in a menu.
    [[nodiscard]] QList<QAction*> actionsOf(PanelMenu menu) const;
    /// Those that show setup, parameters and machine.
    [[nodiscard]] QList<const QWidget*> jobPanels() const;

    /// All docks where a layout has them; those that it does not name are tabs in the area of their rows.
    void arrange(const DockLayout& layout);
    /// QMainWindow::restoreState(), also of a window that had fewer panels: the others have the places that
    /// the last layout gave them. False leaves all as it is.
    bool restore(const QByteArray& state, int version);
    /// Shows a panel in front of others; the id is one of the rows'.
    void show(std::string_view id);
    /// The same, and gives it the focus.
    void activate(std::string_view id);
    void raiseFloating();
    void retitle();

    /// After a change of the content of the fitted dock.
    void fit();
    /// Whether the width of the fitted dock is the user's. Kept with the layout of the window.
    [[nodiscard]] bool isWidthChosen() const;
    void setWidthChosen(bool chosen);

    /// Leads the focus between the docks and the centre.
    [[nodiscard]] PanelFocus& focus() { return *m_focus; }

private:
    void add(const PanelRow& row, const PanelParts& parts);
    [[nodiscard]] QDockWidget& dock(std::string_view id) const;

    QMainWindow& m_window;
    const Session& m_session;
    std::span<const PanelRow> m_rows;
    PanelFocus* m_focus;
    std::vector<QDockWidget*> m_docks; ///< in the order of m_rows
    FittedDock* m_fitted = nullptr;    ///< null where no row asks for it
};

} // namespace proveout
