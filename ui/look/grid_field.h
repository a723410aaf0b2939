// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/simulation/setup/setup.h"

class QCheckBox;

namespace proveout {

class NumberBox;

/// The grid spacing of a setup: a number, or automatic, which shows the spacing that was found. Typing a
/// number ends the automatic grid.
class GridField final : public QWidget {
    Q_OBJECT

public:
    /// The number box gets the name `name`, the switch `name` with "-automatic".
    explicit GridField(const QString& name, QWidget* parent = nullptr);

    /// Shows other values; emits nothing.
    void show(const Setup& setup);
    void put(Setup& setup) const;

signals:
    void edited();

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();

    NumberBox* m_spacing;
    QCheckBox* m_automatic;
};

} // namespace proveout
