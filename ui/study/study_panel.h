// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include <QWidget>

#include "core/study/figures.h"
#include "core/study/forecast_chart.h"
#include "ui/session/session.h"
#include "ui/study/study_runner.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace proveout {

class ChartView;

/// The paper's sweeps on the open program, drawn while they run, and the choice of region size and period,
/// with predicted and measured values side by side.
class StudyPanel final : public QWidget {
    Q_OBJECT

public:
    StudyPanel(Session& session, MakeDrawing makeDrawing, QWidget* parent = nullptr);

    [[nodiscard]] StudyRunner& runner() { return m_runner; }
    [[nodiscard]] const ChartView& view() const { return *m_view; }
    /// Writes the displayed chart as CSV, SVG or PNG, depending on the extension of the file.
    bool exportTo(const QString& file);

protected:
    void changeEvent(QEvent* event) override;

private:
    void startSweep();
    void startOptimising();
    [[nodiscard]] bool useJob();
    void addRun(const StudyRun& run);
    void showForecast();
    void report(const QString& text);
    void useChoice();
    void refresh();
    void askAndExport();
    void setTexts();
    void enable();

    Session& m_session;
    StudyRunner m_runner;
    QComboBox* m_sweeps;
    QPushButton* m_run;
    QPushButton* m_optimise;
    QPushButton* m_cancel;
    QPushButton* m_use;
    QPushButton* m_export;
    QComboBox* m_figures;
    QProgressBar* m_progress;
    QLabel* m_result;
    ChartView* m_view;

    StudySubject m_subject; ///< of the current or the last study
    std::vector<StudyRun> m_runs;
    std::shared_ptr<const Rehearsal> m_rehearsal; ///< null: the last study was a sweep
    std::vector<MeasuredSchedule> m_measured;
};

} // namespace proveout
