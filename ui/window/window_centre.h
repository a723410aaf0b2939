// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QStackedWidget;

namespace proveout {

class Appearance;
class RecentFiles;
class Session;
class StartPage;

/// The middle of the window: the 3D view or the start page, with notices above it. Thread: UI.
class WindowCentre final : public QWidget {
    Q_OBJECT

public:
    /// All arguments must outlive the widget.
    WindowCentre(Session& session, Appearance& appearance, RecentFiles& recent, QWidget* parent);

    [[nodiscard]] QStackedWidget& pages() { return *m_pages; }
    [[nodiscard]] StartPage& startPage() { return *m_startPage; }
    [[nodiscard]] QWidget& viewport() { return *m_viewport; }
    /// Shows a message above the pages, which become smaller; takes ownership.
    void addNotice(QWidget* notice);

private:
    QStackedWidget* m_pages;
    StartPage* m_startPage;
    QWidget* m_viewport;
};

} // namespace proveout
