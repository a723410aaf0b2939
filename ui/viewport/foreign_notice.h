// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/nc/text/dialect.h"
#include "ui/viewport/view_notice.h"

class QMenu;
class QPushButton;

namespace proveout {

class Session;

/// A notice over the view that explains why an unsupported text is not shown, and offers to read it in a
/// dialect that the user chooses. Otherwise hidden.
class ForeignNotice final : public ViewNotice {
    Q_OBJECT

public:
    ForeignNotice(Session& session, QWidget* parent);

protected:
    void changeEvent(QEvent* event) override;

private:
    void readAs(DialectId dialect);
    void showState();

    Session& m_session;
    QPushButton* m_readAs;
    QMenu* m_dialects;
};

} // namespace proveout
