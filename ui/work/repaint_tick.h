// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace proveout {

/// The one clock of repaints: however often it is asked, it fires at most 30 times a second, and leaves a
/// fifth of the time to the user's input where painting takes longer than that.
class RepaintTick : public QObject {
    Q_OBJECT

public:
    explicit RepaintTick(QObject* parent = nullptr);

    void request();
    /// Milliseconds that painting after a tick took lately.
    [[nodiscard]] double paintMilliseconds() const { return m_paintMs; }

    bool event(QEvent* event) override;

signals:
    void fired();

private:
    void fire();

    QTimer m_timer;
    QElapsedTimer m_sinceFired;
    double m_paintMs = 0;
};

} // namespace proveout
