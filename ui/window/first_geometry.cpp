// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/first_geometry.h"

#include <algorithm>

#include <QScreen>
#include <QWidget>

namespace proveout {

namespace {

constexpr QSize kLeast{1280, 800}; ///< the size that the layouts are designed for
constexpr QSize kMost{2200, 1400}; ///< panels do not benefit from more
constexpr QSize kFrame{20, 50};    ///< title bar and borders
constexpr double kShare = 0.85;    ///< share of a screen larger than the minimum

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
