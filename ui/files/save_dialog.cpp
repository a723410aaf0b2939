// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/save_dialog.h"

#include <QFileDialog>
#include <QFileInfo>

namespace proveout {

QString askWhereToSave(QWidget& parent, const QString& title, const QString& proposal, const QString& filter,
                       const QString& suffix) {
    QFileDialog dialog(&parent, title, QFileInfo(proposal).path(), filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setFileMode(QFileDialog::AnyFile);
    dialog.setDefaultSuffix(suffix);
    dialog.selectFile(QFileInfo(proposal).fileName());
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

} // namespace proveout
