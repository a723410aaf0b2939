// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/work_hub.h"

#include <algorithm>
#include <utility>

namespace proveout {

namespace {

/// Same order as WorkKind.
constexpr std::array<const char*, kWorkKinds> kLabels{
    QT_TRANSLATE_NOOP("WorkHub", "Exporting"),
    QT_TRANSLATE_NOOP("WorkHub", "Saving the file"),
    QT_TRANSLATE_NOOP("WorkHub", "Opening the file"),
    QT_TRANSLATE_NOOP("WorkHub", "Reading the program"),
    QT_TRANSLATE_NOOP("WorkHub", "Searching for the block"),
    QT_TRANSLATE_NOOP("WorkHub", "Simulating"),
};

} // namespace

WorkHub::WorkHub(QObject* parent) : QObject(parent) {
    m_clock.start();
}

std::size_t WorkHub::shown() const {
    const auto found = std::ranges::find_if(m_work, [](const State& each) { return each.done.has_value(); });
    return static_cast<std::size_t>(found - m_work.begin());
}

void WorkHub::cancel() {
    const std::size_t kind = std::min(shown(), static_cast<std::size_t>(WorkKind::simulating));
    if (const auto& cancel = m_work.at(kind).cancel)
        cancel();
}

void WorkHub::setCancel(WorkKind kind, std::function<void()> cancel) {
    m_work.at(static_cast<std::size_t>(kind)).cancel = std::move(cancel);
}

void WorkHub::set(WorkKind kind, std::optional<double> done) {
    State& state = m_work.at(static_cast<std::size_t>(kind));
    state.done = done;
    if (done)
        state.forecast.follow(*done, static_cast<double>(m_clock.elapsed()) * 1e-3);
    else
        state.forecast.end();
    std::optional<Work> current;
    if (const std::size_t index = shown(); index < kWorkKinds) {
        const State& of = m_work.at(index);
        current =
            Work{tr(kLabels.at(index)), of.done.value_or(0), of.forecast.secondsLeft(), of.cancel != nullptr};
    }
    if (current == m_current)
        return;
    m_current = std::move(current);
    emit changed();
}

} // namespace proveout
