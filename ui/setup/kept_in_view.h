// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QScrollArea;

namespace proveout {

/// Keeps the field of a form that is being typed in inside the view of its scroll area, while what stands
/// around it comes and goes, until the user scrolls or types elsewhere. Thread: UI.
class KeptInView final : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this.
    KeptInView(QScrollArea& area, QWidget& form);
    /// From now on.
    void keep();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void bring();

    QScrollArea& m_area;
    QWidget& m_form;
    bool m_keeps = false;
};

} // namespace proveout
