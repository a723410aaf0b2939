// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include <QElapsedTimer>
#include <QObject>
#include <QString>

#include "ui/session/work_forecast.h"

namespace proveout {

/// Long operations. If several are running, the first in this list is shown.
enum class WorkKind : std::uint8_t { exporting, saving, opening, reading, searching, simulating };
inline constexpr std::size_t kWorkKinds = 6;

/// A long operation in progress. Value type.
struct Work {
    QString label;
    double done = 0;                ///< in [0, 1]
    std::optional<int> secondsLeft; ///< as WorkForecast
    bool cancellable = true;

    friend bool operator==(const Work&, const Work&) = default;
};

/// The progress of the session's long operations. Thread: the UI thread.
class WorkHub final : public QObject {
    Q_OBJECT

public:
    explicit WorkHub(QObject* parent = nullptr);

    [[nodiscard]] const std::optional<Work>& current() const { return m_current; }
    /// Cancels current(); if nothing is shown, the work of the simulation.
    void cancel();

    /// `cancel` must stay valid as long as the hub.
    void setCancel(WorkKind kind, std::function<void()> cancel);
    /// Progress in [0, 1]; empty if the operation is not running.
    void set(WorkKind kind, std::optional<double> done);

signals:
    void changed();

private:
    struct State {
        std::optional<double> done;
        WorkForecast forecast;
        std::function<void()> cancel;
    };
    /// The index of the operation that is shown; kWorkKinds if there is none.
    [[nodiscard]] std::size_t shown() const;

    std::array<State, kWorkKinds> m_work;
    QElapsedTimer m_clock;
    std::optional<Work> m_current;
};

} // namespace proveout
