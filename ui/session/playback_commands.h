// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <QObject>

#include "ui/look/command_table.h"
#include "ui/session/session.h"

namespace proveout {

/// The commands of the Simulate menu. The main window adds them to the widgets in which their keys are
/// active.
class PlaybackCommands final : public QObject {
    Q_OBJECT

public:
    explicit PlaybackCommands(Session& session, QObject* parent = nullptr);
    [[nodiscard]] const CommandActions<Session>& actions() const { return m_actions; }
    void retranslate();

private:
    void update();

    Session& m_session;
    CommandActions<Session> m_actions;
};

/// The available speeds in blocks per second, ascending; the last one is infinity.
inline constexpr int kSpeedCount = 15;
[[nodiscard]] const std::array<double, kSpeedCount>& speeds();
/// The next lower (-1) or higher (+1) speed from the one nearest to `blocksPerSecond`.
[[nodiscard]] double neighbourSpeed(double blocksPerSecond, int direction);

} // namespace proveout
