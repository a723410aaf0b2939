// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

#include "ui/look/command_table.h"
#include "ui/session/session.h"

class QWidget;

namespace proveout {

class EditorPanel;

/// Undo and Redo of the Edit menu. They act on what had the focus last: the text, or setup, tuning and
/// machine; their names contain the step. Thread: UI.
class UndoCommands final : public QObject {
    Q_OBJECT

public:
    /// `jobPanels` show setup, parameters and machine. All arguments must outlive this object.
    UndoCommands(Session& session, EditorPanel& editor, QList<const QWidget*> jobPanels, QObject* parent);
    [[nodiscard]] const CommandActions<UndoCommands>& actions() const { return m_actions; }
    void retranslate();
    void undo();
    void redo();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void focusMoved(const QWidget* focus);
    [[nodiscard]] bool isInJobPanel(const QWidget& widget) const;
    [[nodiscard]] bool isInEditor(const QWidget& widget) const;
    void jobChanged();
    void update();

    Session& m_session;
    EditorPanel& m_editor;
    QList<const QWidget*> m_jobPanels;
    bool m_ofText = false; ///< false: acts on setup, tuning and machine
    CommandActions<UndoCommands> m_actions;
};

} // namespace proveout
