// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ui/viewport/view_notice.h"

class QPushButton;
class QToolButton;

namespace proveout {

class Session;

/// Says over the view that moves are not simulated because their tools are missing, or that sizes of tools
/// are not confirmed, and offers what mends it. Hidden where there is nothing to say.
class ToolNotice final : public ViewNotice {
    Q_OBJECT

public:
    ToolNotice(Session& session, QWidget* parent);

protected:
    void changeEvent(QEvent* event) override;

private:
    void showState();
    [[nodiscard]] QString missingText(const std::vector<int>& missing);
    [[nodiscard]] QString unconfirmedText();

    Session& m_session;
    QPushButton* m_define;
    QPushButton* m_mend; ///< assume the missing tools, or confirm those that are there
    QToolButton* m_close;
    int m_tool = 0;           ///< that m_define is about
    bool m_missing = false;   ///< else the notice is about unconfirmed tools
    bool m_dismissed = false; ///< the user has closed the notice about unconfirmed tools of this document
};

} // namespace proveout
