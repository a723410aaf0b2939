// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/simulation/setup/setup.h"

class QCheckBox;

namespace proveout {

class NumberBox;

/// The grid spacing of a setup: a number, or automatic, which shows the computed spacing. Typing a number
/// turns the automatic grid off.
class GridField final : public QWidget {
    Q_OBJECT

public:
    /// The object name of the number box is `name`, that of the check box is `name` plus "-automatic".
    explicit GridField(const QString& name, QWidget* parent = nullptr);

    /// Shows the values of the setup; emits nothing.
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
