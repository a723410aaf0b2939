// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>

#include "ui/session/session.h"

class QActionGroup;

namespace proveout {

/// How much memory the simulation may keep to go back quickly; kept in the settings.
class CheckpointMenu final : public QMenu {
    Q_OBJECT

public:
    /// The session outlives the menu.
    CheckpointMenu(Session& session, QWidget* parent);

private:
    void fill();
    void choose(std::size_t megabytes);

    Session& m_session;
    QActionGroup* m_group;
};

} // namespace proveout
