// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>

#include "core/nc/program/control_state.h"
#include "ui/program/program_source.h"
#include "ui/session/session.h"

class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace proveout {

/// The state of the control at the block that was executed last: modal codes, positions, offsets, variables
/// and calls. The program is interpreted up to that block in the background while playback is paused.
class ControlPanel final : public QWidget {
    Q_OBJECT

public:
    explicit ControlPanel(Session& session, QWidget* parent = nullptr);

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void retranslate();
    void ask();
    void adopt(const std::shared_ptr<const Program>& program);
    void fill(const ControlState& state);
    [[nodiscard]] QString valueText(const ControlState::Quantity& quantity) const;
    QTreeWidgetItem* section(const QString& title);
    QTreeWidgetItem& addRow(QTreeWidgetItem& parent, const QString& name, const QString& value,
                            const QString& meaning = {});

    Session& m_session;
    QTreeWidget* m_tree;
    QLabel* m_empty;
    ProgramSource m_source;
    QTimer m_rest;
    std::shared_ptr<const Program> m_shown;   ///< interpreted up to the block
    std::shared_ptr<const Program> m_askedOf; ///< the session's program of the last request
    std::size_t m_askedBlock = 0;
};

} // namespace proveout
