// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <QWidget>

#include "ui/look/command_table.h"
#include "ui/program/program_source.h"
#include "ui/session/session.h"

class QLabel;
class QToolButton;

namespace proveout {

class FileChangedBar;
class FindBar;
class NcEditor;

/// The NC program: the text, the find bar, and the bar that reports changes on disk. Its actions() are the
/// Edit menu.
class EditorPanel final : public QWidget {
    Q_OBJECT

public:
    explicit EditorPanel(Session& session, QWidget* parent = nullptr);
    [[nodiscard]] NcEditor& editor() { return *m_editor; }
    /// Wide enough for the program's lines, except a few long ones.
    [[nodiscard]] QSize sizeHint() const override;
    /// Checkable: during playback the current line stays visible. Working in the text turns this off, so that
    /// the text does not scroll away from the cursor, until playback starts again or the user turns it on.
    [[nodiscard]] QAction& followAction() { return *m_follow; }

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    static const std::array<Command<EditorPanel>, 12> kCommands;

    void retranslate();
    void loadText();
    void showReadOnly();
    void showFrame(const FramePtr& frame);
    void makeFollowing();
    void pauseFollowing();
    void chooseFollowing(bool on);
    void followPlayback();
    void showFollowing();
    void showProblems();
    void showBreakpoints();
    void updateActions();
    void askForValues(std::uint32_t line, bool toEnd);
    void showValues(const Program& program);

    Session& m_session;
    NcEditor* m_editor;
    FindBar* m_find;
    FileChangedBar* m_changed;
    QLabel* m_readOnly;
    QAction* m_follow;
    QToolButton* m_followAgain; ///< over the text, while following is off
    bool m_wasPlaying = false;
    bool m_followingPaused = false; ///< by work in the text, not by the user's choice
    CommandActions<EditorPanel> m_commands;
    ProgramSource m_values; ///< interpreted up to the line under the mouse
    bool m_counts = false;  ///< m_values is interpreted to the end, to count the executions
};

} // namespace proveout
