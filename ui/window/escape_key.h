// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace proveout {

class ContactHub;

/// Makes Esc hide a contact first, whatever has the focus: the editor and the find bar would use that key.
/// Active as long as this object exists. Thread: UI.
class EscapeKey final : public QObject {
    Q_OBJECT

public:
    /// `contact` must outlive this object.
    EscapeKey(const ContactHub& contact, QObject* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    const ContactHub& m_contact;
};

} // namespace proveout
