// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

#include "ui/document/edit_claim.h"
#include "ui/session/session.h"

class QLabel;

namespace proveout {

/// "bracket.nc has unsaved changes in another window": a bar above the content of the file, shown as long as
/// that is so.
class EditedElsewhereBar final : public QFrame {
    Q_OBJECT

public:
    /// The session must outlive the bar.
    EditedElsewhereBar(Session& session, FilePart part, QWidget* parent);

protected:
    void changeEvent(QEvent* event) override;

private:
    void follow();
    void showOther();
    [[nodiscard]] QString file() const;

    Session& m_session;
    FilePart m_part;
    EditClaim m_claim;
    QLabel* m_text;
};

} // namespace proveout
