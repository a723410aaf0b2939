// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/memory_menu.h"

#include <array>
#include <utility>

#include <QActionGroup>
#include <QSettings>

#include "core/base/memory.h"
#include "ui/look/diagnostic_text.h"

namespace proveout {

namespace {

constexpr std::size_t kMegabyte = 1'000'000;
constexpr std::array<std::size_t, 7> kChoices{100, 250, 500, 1000, 2000, 4000, 8000};
constexpr std::size_t kDefault = 1000;

} // namespace

MemoryMenu::MemoryMenu(QString key, Apply apply, QWidget* parent)
    : QMenu(parent), m_key(std::move(key)), m_apply(std::move(apply)), m_group(new QActionGroup(this)) {
    connect(this, &QMenu::aboutToShow, this, &MemoryMenu::fill);
    fill();
    m_apply(chosen() * kMegabyte);
}

std::size_t MemoryMenu::chosen() const {
    return QSettings().value(m_key, static_cast<qulonglong>(kDefault)).toULongLong();
}

/// Filled each time it is shown, because the language may have changed.
void MemoryMenu::fill() {
    clear();
    for (const std::size_t megabytes : kChoices) {
        const QString amount = figuresText(readableBytes(static_cast<double>(megabytes * kMegabyte)));
        QAction* action = addAction(megabytes == kDefault ? tr("%1 (default)").arg(amount) : amount);
        action->setCheckable(true);
        action->setChecked(megabytes == chosen());
        m_group->addAction(action);
        connect(action, &QAction::triggered, this, [this, megabytes] { choose(megabytes); });
    }
}

void MemoryMenu::choose(std::size_t megabytes) {
    QSettings().setValue(m_key, static_cast<qulonglong>(megabytes));
    m_apply(megabytes * kMegabyte);
}

} // namespace proveout
