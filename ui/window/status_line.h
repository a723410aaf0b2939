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

/// The content of the status bar: the position under the pointer; tool position, feed rate, spindle speed,
/// tool, block, triangles; and long operations with a Cancel button. The fields have fixed widths, so that
/// the layout does not change with the numbers.
class StatusLine final : public QObject {
    Q_OBJECT

public:
    StatusLine(Session& session, QStatusBar& bar);
    /// Also shows the position under the pointer; `pointer` must outlive the last tick of the session.
    void follow(const SurfaceProbe& pointer);
    void retranslate();
    /// Shows the first problem for a while, at most until it is resolved.
    void reportProblem();

private:
    enum Field { kX, kY, kZ, kFeed, kSpindle, kTool, kBlock, kFaces, kFieldCount };

    void onTick(const FramePtr& frame);
    void showFrame(const FramePtr& frame);
    [[nodiscard]] QString toolText(const Frame& frame) const;
    void showWork();
    void reportStop(const BreakpointHit& hit);
    void reportPlace(const PlaceAnswer& answer);
    /// The event that makes a message outdated.
    enum class Until { moved, edited };
    void say(const QString& text, Until until, std::size_t block = 0, int milliseconds = 0);
    void forget(Until event);
    void forgetProblem();
    void forgetWhatIsBehind(const Frame& frame);
    void showPlace();
    /// Makes each field as wide as its widest text for the current program and stock.
    void fitFields();
    void set(Field field, const QString& text);

    Session& m_session;
    QStatusBar& m_bar;
    std::array<QLabel*, kFieldCount> m_fields{};
    const SurfaceProbe* m_pointer = nullptr;
    ElidedLabel* m_place; ///< the position under the pointer
    QProgressBar* m_progress;
    QToolButton* m_cancel;
    QString m_problem; ///< shown by reportProblem()
    QString m_said;    ///< shown by say(); another message may have replaced it
    Until m_until = Until::edited;
    std::size_t m_saidOf = 0;    ///< the block that the message is about
    bool m_arrived = false;      ///< at the block m_saidOf
    std::size_t m_facesFull = 0; ///< of the newest frame
    bool m_toolAssumed = false;  ///< in the newest frame
};

} // namespace proveout
