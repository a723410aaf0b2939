// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QTimer>
#include <QWidget>

#include "ui/session/session.h"

class QLabel;

namespace proveout {

class NumberBox;

/// The speeds of the machine, one row per field of describe(), and the machine time of the program.
class MachineForm final : public QWidget {
    Q_OBJECT

public:
    explicit MachineForm(Session& session, QWidget* parent = nullptr);

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void showMachine();
    void showTimes();
    void apply();

    Session& m_session;
    std::vector<QLabel*> m_labels; ///< same order as the fields
    std::vector<NumberBox*> m_boxes;
    QLabel* m_times;
    QTimer m_rest;
};

} // namespace proveout
