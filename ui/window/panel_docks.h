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

/// The docks of a window: creates one per panel, manages their titles, arranges them and brings them to the
/// front. Thread: UI.
class PanelDocks final : public QObject {
    Q_OBJECT

public:
    /// `centre` contains the pages in the middle of the window. The referenced arguments must outlive this
    /// object; the docks belong to the window.
    PanelDocks(QMainWindow& window, QStackedWidget& centre, const PanelParts& parts,
               std::span<const PanelRow> rows);

    [[nodiscard]] std::span<const PanelRow> rows() const { return m_rows; }
    /// Same order as the rows.
    [[nodiscard]] const std::vector<QDockWidget*>& all() const { return m_docks; }
    /// The panel of this class; null if there is none.
    template<class Panel>
    [[nodiscard]] Panel* panel() const {
        for (const QDockWidget* dock : m_docks) {
            if (auto* found = qobject_cast<Panel*>(dock->widget()))
                return found;
        }
        return nullptr;
    }
    /// The actions() of the panels whose actions belong in this menu.
    [[nodiscard]] QList<QAction*> actionsOf(PanelMenu menu) const;
    /// The panels that show setup, parameters and machine.
    [[nodiscard]] QList<const QWidget*> jobPanels() const;

    /// Arranges all docks according to a layout; docks that it does not name become tabs in the area of their
    /// row.
    void arrange(const DockLayout& layout);
    /// Like QMainWindow::restoreState(), but also for the state of a window with fewer panels: the others
    /// keep the places from the last layout. If it returns false, nothing has changed.
    bool restore(const QByteArray& state, int version);
    /// Brings a panel to the front; the id must be that of a row.
    void show(std::string_view id);
    /// The same, and also gives it the focus.
    void activate(std::string_view id);
    void raiseFloating();
    void retitle();

    /// Call it after a change of the content of the fitted dock.
    void fit();
    /// Whether the user has set the width of the fitted dock. Stored with the layout of the window.
    [[nodiscard]] bool isWidthChosen() const;
    void setWidthChosen(bool chosen);

    /// Manages the focus of the docks and the centre.
    [[nodiscard]] PanelFocus& focus() { return *m_focus; }

private:
    void add(const PanelRow& row, const PanelParts& parts);
    [[nodiscard]] QDockWidget& dock(std::string_view id) const;

    QMainWindow& m_window;
    const Session& m_session;
    std::span<const PanelRow> m_rows;
    PanelFocus* m_focus;
    std::vector<QDockWidget*> m_docks; ///< same order as m_rows
    FittedDock* m_fitted = nullptr;    ///< null if no row requires it
};

} // namespace proveout
