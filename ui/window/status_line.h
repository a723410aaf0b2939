// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include <QObject>

#include "ui/session/session.h"

class QLabel;
class QProgressBar;
class QStatusBar;
class QToolButton;

namespace proveout {

class ElidedLabel;
class SurfaceProbe;

/// What the status bar tells: the place under the pointer; position, feed, speed, tool, block, faces; and
/// long work with a Cancel button. The fields have fixed widths, so that nothing jumps while numbers change.
class StatusLine final : public QObject {
    Q_OBJECT

public:
    StatusLine(Session& session, QStatusBar& bar);
    /// Shows the place under the pointer, too; it must outlive the last tick of the session.
    void follow(const SurfaceProbe& pointer);
    void retranslate();
    /// The first problem, for a while; no longer than it is one.
    void reportProblem();

private:
    enum Field { kX, kY, kZ, kFeed, kSpindle, kTool, kBlock, kFaces, kFieldCount };

    void onTick(const FramePtr& frame);
    void showFrame(const FramePtr& frame);
    [[nodiscard]] QString toolText(const Frame& frame) const;
    void showWork();
    void reportStop(const BreakpointHit& hit);
    void reportPlace(const PlaceAnswer& answer);
    /// How long what a message says is true.
    enum class Until { moved, edited };
    void say(const QString& text, Until until, std::size_t block = 0, int milliseconds = 0);
    void forget(Until event);
    void forgetProblem();
    void forgetWhatIsBehind(const Frame& frame);
    void showPlace();
    /// Makes each field as wide as the widest text that it will show for this program and stock.
    void fitFields();
    void set(Field field, const QString& text);

    Session& m_session;
    QStatusBar& m_bar;
    std::array<QLabel*, kFieldCount> m_fields{};
    const SurfaceProbe* m_pointer = nullptr;
    ElidedLabel* m_place; ///< under the pointer
    QProgressBar* m_progress;
    QToolButton* m_cancel;
    QString m_problem; ///< that reportProblem() has shown
    QString m_said;    ///< by say(); something else may be shown meanwhile
    Until m_until = Until::edited;
    std::size_t m_saidOf = 0;    ///< the block that it is about
    bool m_arrived = false;      ///< there
    std::size_t m_facesFull = 0; ///< of the newest frame
    bool m_toolAssumed = false;  ///< the same
};

} // namespace proveout
