// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dock_layouts.h"

#include <algorithm>
#include <array>

#include <QCoreApplication>
#include <QDockWidget>

namespace proveout {

namespace {

// Shares of the window's width. The view in the middle always keeps the rest.
constexpr double kNarrowestLeft = 0.20;
constexpr double kWidestLeft = 0.34;
constexpr double kRight = 0.15; // unless the content needs more

QDockWidget* dockNamed(const QMainWindow& window, const char* id) {
    return window.findChild<QDockWidget*>(QLatin1String(id));
}

/// A floating dock is docked before it is removed: docking it as a tab among docks that have just been added
/// has crashed in Qt.
void removeDock(QMainWindow& window, QDockWidget& dock) {
    dock.setFloating(false);
    window.removeDockWidget(&dock);
}

/// Adds docks as tabs behind `first`, which is already in its place.
void addTabs(QMainWindow& window, const DockTabs& tabs) {
    for (std::size_t i = 1; i < tabs.size(); ++i) {
        window.tabifyDockWidget(dockNamed(window, tabs[i - 1]), dockNamed(window, tabs[i]));
        dockNamed(window, tabs[i])->show();
    }
}

void fillArea(QMainWindow& window, Qt::DockWidgetArea area, const std::vector<DockTabs>& places) {
    QDockWidget* above = nullptr;
    for (const DockTabs& tabs : places) {
        QDockWidget* first = dockNamed(window, tabs.front());
        window.addDockWidget(area, first);
        first->show();
        if (above != nullptr)
            window.splitDockWidget(above, first, Qt::Vertical);
        above = first;
    }
    // Tabs come last, because splitting tabbed docks would split the wrong area.
    for (const DockTabs& tabs : places)
        addTabs(window, tabs);
}

/// The width at which the docks of a column show all of their content.
int neededWidth(const QMainWindow& window, const std::vector<DockTabs>& places) {
    int widest = 0;
    for (const DockTabs& tabs : places)
        for (const char* id : tabs)
            widest = std::max(widest, dockNamed(window, id)->widget()->minimumSizeHint().width());
    return widest;
}

QList<QDockWidget*> firstOf(const QMainWindow& window, const std::vector<DockTabs>& places) {
    QList<QDockWidget*> docks;
    for (const DockTabs& tabs : places)
        docks << dockNamed(window, tabs.front());
    return docks;
}

void giveSizes(QMainWindow& window, const DockLayout& layout) {
    QList<QDockWidget*> columns;
    QList<int> widths;
    if (!layout.left.empty()) {
        columns << dockNamed(window, layout.left.front().front());
        widths << leftDockWidth(window.width(), columns.back()->widget()->sizeHint().width());
    }
    if (!layout.right.empty()) {
        columns << dockNamed(window, layout.right.front().front());
        widths << std::max(neededWidth(window, layout.right), static_cast<int>(window.width() * kRight));
    }
    window.resizeDocks(columns, widths, Qt::Horizontal);
    QList<QDockWidget*> rows = firstOf(window, layout.bottom);
    QList<int> heights;
    const auto all = static_cast<int>(window.height() * layout.bottomShare);
    for (const QDockWidget* row : rows)
        heights << (row == rows.back() ? row->widget()->sizeHint().height()
                                       : all / std::max(1, static_cast<int>(rows.size()) - 1));
    window.resizeDocks(rows, heights, Qt::Vertical);
}

} // namespace

std::span<const DockLayout> dockLayouts() {
    static const std::array<DockLayout, 2> kLayouts{{
        {"machinist",
         QT_TRANSLATE_NOOP("Layouts", "&Machinist"),
         QT_TRANSLATE_NOOP("Layouts", "Program, setup and problems in front; playback in machine time"),
         {{"dock-program"}},
         {{"dock-setup", "dock-tuning", "dock-control"}},
         {{"dock-problems", "dock-plots", "dock-breakpoints", "dock-part", "dock-study"}, {"dock-timeline"}},
         PlayBy::time,
         10,
         0.19},
        {"research",
         QT_TRANSLATE_NOOP("Layouts", "&Research"),
         QT_TRANSLATE_NOOP("Layouts", "Tuning and plots in front; playback by blocks"),
         {{"dock-program", "dock-setup", "dock-control"}},
         {{"dock-tuning"}},
         {{"dock-plots", "dock-problems", "dock-breakpoints", "dock-part", "dock-study"}, {"dock-timeline"}},
         PlayBy::blocks,
         1,
         0.24},
    }};
    return kLayouts;
}

const DockLayout& dockLayout(std::string_view id) {
    const std::span<const DockLayout> all = dockLayouts();
    const auto found =
        std::find_if(all.begin(), all.end(), [id](const DockLayout& row) { return row.id == id; });
    return found == all.end() ? all.front() : *found;
}

void placeUnnamed(DockLayout& layout, const char* id, DockArea area) {
    const auto isNamed = [id](const DockTabs& tabs) {
        return std::find(tabs.begin(), tabs.end(), std::string_view(id)) != tabs.end();
    };
    for (const std::vector<DockTabs>* places : {&layout.left, &layout.right, &layout.bottom}) {
        if (std::any_of(places->begin(), places->end(), isNamed))
            return;
    }
    std::vector<DockTabs>& places = area == DockArea::left    ? layout.left
                                    : area == DockArea::right ? layout.right
                                                              : layout.bottom;
    if (places.empty())
        places.emplace_back();
    places.front().push_back(id);
}

int leftDockWidth(int windowWidth, int wanted) {
    return std::clamp(wanted, static_cast<int>(windowWidth * kNarrowestLeft),
                      static_cast<int>(windowWidth * kWidestLeft));
}

void arrangeDocks(QMainWindow& window, const DockLayout& layout) {
    // Starts without docks: intermediate arrangements could require more width than the window has, and the
    // window would stay that wide.
    for (const std::vector<DockTabs>* area : {&layout.left, &layout.right, &layout.bottom})
        for (const DockTabs& tabs : *area)
            for (const char* id : tabs)
                removeDock(window, *dockNamed(window, id));
    window.setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    window.setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
    window.setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    fillArea(window, Qt::LeftDockWidgetArea, layout.left);
    fillArea(window, Qt::RightDockWidgetArea, layout.right);
    fillArea(window, Qt::BottomDockWidgetArea, layout.bottom);
    for (const std::vector<DockTabs>* area : {&layout.left, &layout.right, &layout.bottom})
        for (QDockWidget* dock : firstOf(window, *area))
            dock->raise();
    giveSizes(window, layout);
}

} // namespace proveout
