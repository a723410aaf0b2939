// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>

#include "ui/session/session.h"

class QActionGroup;

namespace proveout {

/// The choice of how much memory the simulation may use for checkpoints; stored in the settings.
class CheckpointMenu final : public QMenu {
    Q_OBJECT

public:
    /// The session must outlive the menu.
    CheckpointMenu(Session& session, QWidget* parent);

private:
    void fill();
    void choose(std::size_t megabytes);

    Session& m_session;
    QActionGroup* m_group;
};

} // namespace proveout
