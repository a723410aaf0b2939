// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace proveout {

/// Passes Space to the focused control if it uses that key (buttons, boxes and lists), although Space is a
/// shortcut for playing the program. Active as long as this object exists. Thread: UI.
class SpaceKey final : public QObject {
    Q_OBJECT

public:
    explicit SpaceKey(QObject* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace proveout
