// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "ui/viewport/view_notice.h"

class QPushButton;
class QToolButton;

namespace proveout {

class Session;

/// A notice over the view that moves are not simulated because their tools are missing, or that tool sizes
/// are unconfirmed, with buttons to fix it. Hidden if neither is the case.
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
    QPushButton* m_mend; ///< adds the missing tools with assumed sizes, or confirms the existing ones
    QToolButton* m_close;
    int m_tool = 0;           ///< the tool that m_define defines
    bool m_missing = false;   ///< false: the notice is about unconfirmed tools
    bool m_dismissed = false; ///< the user has closed the notice about unconfirmed tools for this document
};

} // namespace proveout
