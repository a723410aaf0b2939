// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <QDialog>

class QLineEdit;

namespace proveout {

/// Asks why a finding does not count, and who answers for that; accepted only with both. The person is
/// remembered for the next time.
class WaiveDialog final : public QDialog {
    Q_OBJECT

public:
    /// `sentence`: of the finding, in the user's language.
    WaiveDialog(const QString& sentence, QWidget* parent);

    [[nodiscard]] std::string reason() const;
    [[nodiscard]] std::string owner() const;
    void accept() override;

private:
    QLineEdit* m_reason;
    QLineEdit* m_owner;
};

} // namespace proveout
