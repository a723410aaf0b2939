// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QScrollArea;

namespace proveout {

/// Keeps the form field in which the user is typing visible in its scroll area while widgets around it are
/// shown and hidden, until the user scrolls or types elsewhere. Thread: UI.
class KeptInView final : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this object.
    KeptInView(QScrollArea& area, QWidget& form);
    /// Starts to keep the field in view.
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
