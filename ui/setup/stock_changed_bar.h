// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

#include "ui/session/session.h"

class QLabel;
class QPushButton;

namespace proveout {

/// "blank.pvstock has changed on disk: Reload, Keep This Version". The session's signals show and hide it.
class StockChangedBar final : public QFrame {
    Q_OBJECT

public:
    /// The session must outlive the bar.
    StockChangedBar(Session& session, QWidget* parent);

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void writeSentence();

    Session& m_session;
    QLabel* m_text;
    QPushButton* m_reload;
    QPushButton* m_keep;
};

} // namespace proveout
