// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/window_tool_bar.h"

#include <QToolButton>

#include "ui/window/main_window.h"
#include "ui/window/verdict_badge.h"
#include "ui/window/window_commands.h"

namespace proveout {

namespace {

constexpr int kIconSize = 20; ///< px

} // namespace

WindowToolBar::WindowToolBar(MainWindow& window) : QToolBar(&window) {
    setObjectName(QStringLiteral("tool-bar"));
    setMovable(false);
    setIconSize({kIconSize, kIconSize});
    for (const char* id : toolBarIds()) {
        if (*id == '\0')
            addSeparator();
        else if (QAction* command = window.action(QLatin1String(id)))
            addAction(command); // without OpenGL the 3D view has no commands
    }
    for (QToolButton* button : findChildren<QToolButton*>())
        button->setFocusPolicy(Qt::TabFocus);
    addVerdict(window);
    window.addToolBar(this);
}

/// At the right end.
void WindowToolBar::addVerdict(MainWindow& window) {
    auto* space = new QWidget(this);
    space->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    addWidget(space);
    auto* badge = new VerdictBadge(window.session(), this);
    QAction* place = addWidget(badge);
    const auto show = [place, badge] { place->setVisible(badge->hasVerdict()); };
    connect(badge, &VerdictBadge::shown, place, show);
    connect(badge, &VerdictBadge::clicked, this, &WindowToolBar::findingsWanted);
    show();
}

void WindowToolBar::retranslate() {
    setWindowTitle(tr("Toolbar"));
    toggleViewAction()->setVisible(false);
}

} // namespace proveout
