// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/session/playback_commands.h"
#include "ui/session/session.h"
#include "ui/timeline/activity_follower.h"

class QComboBox;
class QHBoxLayout;
class QLabel;

namespace proveout {

class TimelineScale;

/// Transport buttons, the range of all blocks, the machine time, and the playback speed.
class TimelinePanel final : public QWidget {
    Q_OBJECT

public:
    /// `commands` must outlive the panel; their keys are active here too.
    TimelinePanel(Session& session, const PlaybackCommands& commands, QWidget* parent = nullptr);
    [[nodiscard]] TimelineScale& scale() { return *m_scale; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void addTransport(QHBoxLayout& layout, const PlaybackCommands& commands);
    void addReadings(QHBoxLayout& layout);
    void retranslate();
    void namePaces();
    void nameSpeeds();
    [[nodiscard]] QString speedName(double speed, PlayBy by) const;
    [[nodiscard]] QString lagText(double speed) const;
    void showLag(const FramePtr& frame);
    void showTime(std::size_t block);
    void showTimes();
    void showSpeed();
    void chooseSpeed(int index);
    void showProgram();
    void showFrame(const FramePtr& frame);
    void showActivity(const FramePtr& frame);
    void reportShares();
    void showTip(std::size_t block, QPoint globalPlace);

    Session& m_session;
    ActivityFollower m_activity;
    TimelineScale* m_scale;
    QLabel* m_position;
    QLabel* m_time;
    QLabel* m_lag;
    QComboBox* m_by;
    QLabel* m_speedLabel;
    QComboBox* m_speed;
    QString m_timeTip;                  ///< machine time only, without simulated shares
    PlayBy m_namedFor = PlayBy::blocks; ///< the mode that the names of the speeds refer to
};

} // namespace proveout
