// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include <QAction>
#include <QList>
#include <QObject>
#include <QString>

namespace proveout {

/// Turns a command on or off even while it is disabled because the open job has no use for it.
void triggerSwitch(QAction& action);

/// Stores in the settings which commands are on: all that are checkable and have an objectName. Thread: UI.
class KeptSwitches final : public QObject {
    Q_OBJECT

public:
    /// The current states become the defaults; then the commands are set to the states in the settings. The
    /// actions must outlive this object. `group` is a name in the settings.
    KeptSwitches(QString group, const QList<QAction*>& actions, QObject* parent);
    /// Restores the defaults.
    void reset();

private:
    using States = std::vector<std::pair<QAction*, bool>>;
    static void bring(const States& states);

    QString m_group;
    States m_default;
};

} // namespace proveout
