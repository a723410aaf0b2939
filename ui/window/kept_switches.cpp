// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/kept_switches.h"

#include <QSettings>

namespace proveout {

void triggerSwitch(QAction& action) {
    const bool isEnabled = action.isEnabled();
    action.setEnabled(true);
    action.trigger();
    if (!isEnabled)
        action.setEnabled(false);
}

KeptSwitches::KeptSwitches(QString group, const QList<QAction*>& actions, QObject* parent)
    : QObject(parent), m_group(std::move(group)) {
    const QSettings settings;
    States kept;
    const auto key = [this](const QAction& action) {
        return QStringLiteral("%1/%2").arg(m_group, action.objectName());
    };
    for (QAction* action : actions) {
        if (!action->isCheckable() || action->objectName().isEmpty())
            continue;
        m_default.emplace_back(action, action->isChecked());
        // An action that is not in the settings was added by this version.
        kept.emplace_back(action, settings.value(key(*action), action->isChecked()).toBool());
    }
    bring(kept);
    for (const auto& [action, on] : m_default)
        connect(action, &QAction::toggled, this,
                [key, action = action](bool checked) { QSettings().setValue(key(*action), checked); });
}

void KeptSwitches::reset() {
    bring(m_default);
}

void KeptSwitches::bring(const States& states) {
    // In an exclusive group the action that is turned on decides, so it is triggered last.
    for (const bool last : {false, true}) {
        for (const auto& [action, on] : states) {
            if (on == last && action->isChecked() != on)
                triggerSwitch(*action);
        }
    }
}

} // namespace proveout
