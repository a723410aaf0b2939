// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

#include "ui/viewport/closer_look.h"

class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QToolButton;

namespace proveout {

/// Size and spacing of the detail region, and the state of its cutting: a small form over the 3D view.
class CloserLookForm final : public QFrame {
    Q_OBJECT

public:
    CloserLookForm(CloserLook& look, QWidget* parent);

    /// The size in the form, mm: of the detail region, or of one that a click would create.
    [[nodiscard]] Vec2 size() const;
    /// The spacing in the form, mm.
    [[nodiscard]] double spacing() const;

signals:
    /// Size or spacing has changed: the region must keep its centre.
    void edited();
    void closed();

protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void showState();
    void retranslate();

    CloserLook& m_look;
    QLabel* m_sizeLabel;
    QDoubleSpinBox* m_width;
    QDoubleSpinBox* m_depth;
    QLabel* m_spacingLabel;
    QDoubleSpinBox* m_spacing;
    QProgressBar* m_progress;
    QToolButton* m_cancel;
    QToolButton* m_again;
    QToolButton* m_close;
    QLabel* m_status;
};

} // namespace proveout
