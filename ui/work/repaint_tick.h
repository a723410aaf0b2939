// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace proveout {

/// The one clock for repaints: it fires at most 30 times per second however often it is requested, and if
/// painting is slower than that, leaves a fifth of the time for user input.
class RepaintTick : public QObject {
    Q_OBJECT

public:
    explicit RepaintTick(QObject* parent = nullptr);

    void request();
    /// Milliseconds that painting took after recent ticks.
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
