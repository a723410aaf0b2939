// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <QTimer>
#include <QWidget>

#include "core/formats/stock_shapes.h"
#include "ui/session/session.h"
#include "ui/work/newest_task.h"

class QLabel;
class QPushButton;

namespace proveout {

class ControlForm;
class FixtureEditor;
class KeptInView;
class MachineForm;
class StockForm;
class ToolTableEditor;

/// The setup of the machine before the program runs: control, stock, grid, fixtures, tools.
class SetupPanel final : public QWidget {
    Q_OBJECT

public:
    explicit SetupPanel(Session& session, QWidget* parent = nullptr);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void retranslate();
    void titleTools();
    void dropInput();
    void showSetup();
    void fill(const Setup& setup);
    void showMissingTools();
    void showControl();
    void showStockProblem();
    void showMemory(const Setup& setup);
    [[nodiscard]] Setup edited(Setup setup) const;
    void apply();
    void applyStock(Setup setup);
    void makeStock(const StockSpec& spec, const std::optional<Vec3>& corner);
    void useStock(const StockSpec& spec, Setup setup);
    void useNoStock(const StockSpec& spec, Setup setup);
    void use(Setup setup);
    void showProblem(const Diagnostics& errors);
    void fitToProgram();
    void showTool(int number);

    Session& m_session;
    QLabel* m_programTitle;
    ControlForm* m_control;
    QLabel* m_stockTitle;
    StockForm* m_stock;
    QPushButton* m_fit;
    QLabel* m_memory;
    QLabel* m_problem;
    QLabel* m_fixturesTitle;
    FixtureEditor* m_fixtures;
    QLabel* m_toolsTitle;
    ToolTableEditor* m_tools;
    KeptInView* m_toolInView = nullptr; ///< owned by the scroll area
    QLabel* m_missing;
    QPushButton* m_define;
    QLabel* m_machineTitle;
    MachineForm* m_machine;
    Setup m_shown; ///< the setup shown last; what differs in the form was edited since
    QTimer m_rest;
    NewestTask m_making; ///< reads a stock from its file
};

} // namespace proveout
