// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QTimer>
#include <QWidget>

#include "ui/session/session.h"

class QLabel;
class QMenu;
class QToolButton;

namespace proveout {

class NumberBox;

/// The machine, one row per field of describe(), profiles to begin with, and the machine time of the program.
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
    void fillProfiles();

    Session& m_session;
    std::vector<QLabel*> m_labels; ///< same order as the fields
    std::vector<NumberBox*> m_boxes;
    QToolButton* m_profiles;
    QMenu* m_profileMenu;
    QLabel* m_times;
    QTimer m_rest;
};

} // namespace proveout
