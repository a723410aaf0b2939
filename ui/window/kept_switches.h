// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include <QAction>
#include <QList>
#include <QObject>
#include <QString>

namespace proveout {

/// Keeps in the settings which commands are on: those that are checkable and have a name, told by it.
/// Thread: UI.
class KeptSwitches final : public QObject {
    Q_OBJECT

public:
    /// What is on now is the standard; then the commands are brought to where the settings have them. They
    /// outlive this object. `group` is a name in the settings.
    KeptSwitches(QString group, const QList<QAction*>& actions, QObject* parent);
    /// Back to the standard.
    void reset();

private:
    using States = std::vector<std::pair<QAction*, bool>>;
    static void bring(const States& states);

    QString m_group;
    States m_default;
};

} // namespace proveout
