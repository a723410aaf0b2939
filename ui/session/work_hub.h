// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include <QObject>
#include <QString>

namespace proveout {

/// Long work that can be cancelled. Of several at once the first in this order is shown.
enum class WorkKind : std::uint8_t { exporting, opening, reading, searching, simulating };
inline constexpr std::size_t kWorkKinds = 5;

/// Long work under way. Value type.
struct Work {
    QString label;
    double done = 0; ///< in [0, 1]

    friend bool operator==(const Work&, const Work&) = default;
};

/// How far the long work of the session is. Thread: the UI thread.
class WorkHub final : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    [[nodiscard]] const std::optional<Work>& current() const { return m_current; }
    /// Cancels current(); where nothing is shown, what the simulation is doing.
    void cancel();

    /// `cancel` lives as long as the hub is asked.
    void setCancel(WorkKind kind, std::function<void()> cancel);
    /// How far it is, in [0, 1]; nothing where it is not under way.
    void set(WorkKind kind, std::optional<double> done);

signals:
    void changed();

private:
    struct State {
        std::optional<double> done;
        std::function<void()> cancel;
    };
    /// The index of the work that is shown; kWorkKinds where there is none.
    [[nodiscard]] std::size_t shown() const;

    std::array<State, kWorkKinds> m_work;
    std::optional<Work> m_current;
};

} // namespace proveout
