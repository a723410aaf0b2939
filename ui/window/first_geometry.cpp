// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/first_geometry.h"

#include <algorithm>

#include <QScreen>
#include <QWidget>

namespace proveout {

namespace {

constexpr QSize kLeast{1280, 800}; ///< what the layouts are made for
constexpr QSize kMost{2200, 1400}; ///< panels gain nothing beyond it
constexpr QSize kFrame{20, 50};    ///< of title bar and borders
constexpr double kShare = 0.85;    ///< of a screen with room for more than the least

} // namespace

QSize firstWindowSize(QSize available) {
    const QSize room = available - kFrame;
    if (room.width() < kLeast.width() || room.height() < kLeast.height())
        return {};
    const QSize share(static_cast<int>(available.width() * kShare),
                      static_cast<int>(available.height() * kShare));
    return share.expandedTo(kLeast).boundedTo(kMost).boundedTo(room);
}

void applyFirstGeometry(QWidget& window) {
    const QSize size = firstWindowSize(window.screen()->availableSize());
    if (size.isEmpty()) {
        window.resize(window.screen()->availableSize());
        window.setWindowState(window.windowState() | Qt::WindowMaximized);
    } else {
        window.resize(size);
    }
}

} // namespace proveout
