// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/setup/fixture_dialog.h"

#include <utility>

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QVBoxLayout>

#include "ui/setup/described_form.h"

namespace proveout {

namespace {

template<class Device>
void ask(QWidget& parent, const QString& title, const Device& proposed,
         std::function<void(const Device&)> use) {
    auto* dialog = new QDialog(parent.window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setObjectName(QStringLiteral("fixture-dialog"));
    dialog->setWindowTitle(title);
    auto* form = new DescribedForm(QStringLiteral("device-"), dialog);
    form->show(proposed);
    form->selectFirst();
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, dialog);
    auto* layout = new QVBoxLayout(dialog);
    layout->addWidget(form);
    layout->addWidget(buttons);
    QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    // The parent may be destroyed while the dialog is open.
    QObject::connect(dialog, &QDialog::accepted, &parent, [form, proposed, use = std::move(use)] {
        Device device = proposed;
        form->put(device);
        use(device);
    });
    dialog->open();
}

} // namespace

void askForVice(QWidget& parent, const Vice& proposed, std::function<void(const Vice&)> use) {
    ask(parent, QCoreApplication::translate("FixtureEditor", "Vice"), proposed, std::move(use));
}

void askForStepClamp(QWidget& parent, const StepClamp& proposed, std::function<void(const StepClamp&)> use) {
    ask(parent, QCoreApplication::translate("FixtureEditor", "Step clamp"), proposed, std::move(use));
}

} // namespace proveout
