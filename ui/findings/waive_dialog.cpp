// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/findings/waive_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>

#include "ui/look/panel_layout.h"

namespace proveout {

namespace {

constexpr int kWidth = 420; ///< px
const QString kOwnerKey = QStringLiteral("check/owner");

} // namespace

WaiveDialog::WaiveDialog(const QString& sentence, QWidget* parent)
    : QDialog(parent), m_reason(new QLineEdit(this)), m_owner(new QLineEdit(this)) {
    setWindowTitle(tr("Waive a Finding"));
    setMinimumWidth(kWidth);
    auto* finding = wrappedLabel(this);
    finding->setText(sentence);
    auto* effect = wrappedLabel(this);
    effect->setText(
        tr("It no longer counts in the verdict. If its block, size, tool or cutter changes, it counts again. "
           "The job file keeps the waiver."));
    m_reason->setObjectName(QStringLiteral("waiver-reason"));
    m_owner->setObjectName(QStringLiteral("waiver-owner"));
    m_owner->setText(QSettings().value(kOwnerKey).toString());
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    QPushButton* waive = buttons->button(QDialogButtonBox::Ok);
    waive->setText(tr("&Waive"));
    auto* layout = new QFormLayout(this);
    layout->addRow(finding);
    layout->addRow(effect);
    layout->addRow(tr("&Reason"), m_reason);
    layout->addRow(tr("&Person"), m_owner);
    layout->addRow(buttons);
    const auto enable = [this, waive] {
        waive->setEnabled(!m_reason->text().trimmed().isEmpty() && !m_owner->text().trimmed().isEmpty());
    };
    for (QLineEdit* field : {m_reason, m_owner})
        connect(field, &QLineEdit::textChanged, this, enable);
    connect(buttons, &QDialogButtonBox::accepted, this, &WaiveDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &WaiveDialog::reject);
    enable();
    resize(kWidth, layout->heightForWidth(kWidth));
    m_reason->setFocus();
}

std::string WaiveDialog::reason() const {
    return m_reason->text().trimmed().toStdString();
}

std::string WaiveDialog::owner() const {
    return m_owner->text().trimmed().toStdString();
}

void WaiveDialog::accept() {
    QSettings().setValue(kOwnerKey, m_owner->text().trimmed());
    QDialog::accept();
}

} // namespace proveout
