// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QLabel;
class QPushButton;
class QToolButton;

namespace proveout {

class Session;

/// Says over the view that moves are not simulated because their tools are missing, or that sizes of tools
/// are not confirmed, and offers what mends it. Hidden where there is nothing to say. It keeps itself at the
/// lower edge of its parent, in the middle.
class ToolNotice final : public QFrame {
    Q_OBJECT

public:
    ToolNotice(Session& session, QWidget* parent);

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void showState();
    void showMissing(const std::vector<int>& missing);
    void showUnconfirmed();
    void place();

    Session& m_session;
    QLabel* m_icon;
    QLabel* m_text;
    QPushButton* m_define;
    QPushButton* m_mend; ///< assume the missing tools, or confirm those that are there
    QToolButton* m_close;
    int m_tool = 0;           ///< that m_define is about
    bool m_missing = false;   ///< else the notice is about unconfirmed tools
    bool m_dismissed = false; ///< the user has closed the notice about unconfirmed tools of this document
};

} // namespace proveout
