// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/checkpoint_menu.h"

#include <array>

#include <QActionGroup>
#include <QSettings>

#include "core/base/memory.h"
#include "ui/look/diagnostic_text.h"

namespace proveout {

namespace {

const QString kKey = QStringLiteral("simulation/checkpoint-megabytes");
constexpr std::size_t kMegabyte = 1'000'000;
constexpr std::array<std::size_t, 7> kChoices{100, 250, 500, 1000, 2000, 4000, 8000};
constexpr std::size_t kDefault = 1000;

} // namespace

CheckpointMenu::CheckpointMenu(Session& session, QWidget* parent)
    : QMenu(parent), m_session(session), m_group(new QActionGroup(this)) {
    setObjectName(QStringLiteral("checkpoint-menu"));
    connect(this, &QMenu::aboutToShow, this, &CheckpointMenu::fill);
    fill();
    if (const auto kept = QSettings().value(kKey); kept.isValid())
        m_session.playback().setCheckpointBudget(kept.toULongLong() * kMegabyte);
}

/// Filled each time it is shown, because the language may have changed.
void CheckpointMenu::fill() {
    clear();
    const std::size_t present = QSettings().value(kKey, static_cast<qulonglong>(kDefault)).toULongLong();
    for (const std::size_t megabytes : kChoices) {
        const QString amount = figuresText(readableBytes(static_cast<double>(megabytes * kMegabyte)));
        QAction* action = addAction(megabytes == kDefault ? tr("%1 (default)").arg(amount) : amount);
        action->setCheckable(true);
        action->setChecked(megabytes == present);
        m_group->addAction(action);
        connect(action, &QAction::triggered, this, [this, megabytes] { choose(megabytes); });
    }
}

void CheckpointMenu::choose(std::size_t megabytes) {
    QSettings().setValue(kKey, static_cast<qulonglong>(megabytes));
    m_session.playback().setCheckpointBudget(megabytes * kMegabyte);
}

} // namespace proveout
