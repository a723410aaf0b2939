// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace proveout {

/// Leaves Space to the controls of the application that are worked by it, buttons, boxes and lists, although
/// it plays the program from anywhere else. Holds as long as this object lives. Thread: UI.
class SpaceKey final : public QObject {
    Q_OBJECT

public:
    explicit SpaceKey(QObject* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

} // namespace proveout
