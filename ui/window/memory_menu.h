// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

#include <QMenu>
#include <QString>

class QActionGroup;

namespace proveout {

/// The choice of how much memory something may use; stored in the settings.
class MemoryMenu final : public QMenu {
    Q_OBJECT

public:
    using Apply = std::function<void(std::size_t bytes)>;

    /// `key`: of the settings, in megabytes. `apply` is called at once, and after each choice.
    MemoryMenu(QString key, Apply apply, QWidget* parent);

private:
    void fill();
    [[nodiscard]] std::size_t chosen() const; ///< megabytes
    void choose(std::size_t megabytes);

    QString m_key;
    Apply m_apply;
    QActionGroup* m_group;
};

} // namespace proveout
