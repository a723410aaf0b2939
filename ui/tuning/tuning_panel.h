// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>

#include "ui/session/session.h"

class QLabel;

namespace proveout {

class GridField;
class ParameterForm;

/// The decimation parameters and the grid, which can be changed during playback, with their measured effect.
class TuningPanel final : public QWidget {
    Q_OBJECT

public:
    explicit TuningPanel(Session& session, QWidget* parent = nullptr);
    [[nodiscard]] ParameterForm& form() { return *m_form; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void apply();
    void applyGrid();
    /// Another document is open.
    void dropInput();
    void showParameters();
    void showSetup();
    /// An empty text hides the line.
    void showProblem(const QString& text);
    void colourProblem();
    void showEffect(const FramePtr& frame);
    [[nodiscard]] QString heldBackText(const Frame& frame) const;

    Session& m_session;
    ParameterForm* m_form;
    QLabel* m_gridLabel;
    GridField* m_grid;
    QLabel* m_problemIcon;
    QLabel* m_problem;
    QLabel* m_effectTitle;
    QLabel* m_faces;
    QLabel* m_error;
    QLabel* m_regions;
    QLabel* m_heldBack;
    // The values shown last; what differs in the form was edited since.
    DecimationParameters m_shownParameters;
    Setup m_shownSetup;
    QTimer m_rest; ///< changes are applied after a short pause
};

} // namespace proveout
