// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/save_question.h"

#include <filesystem>
#include <system_error>

#include <QCoreApplication>
#include <QDateTime>
#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>

#include "ui/document/file_paths.h"
#include "ui/files/compare_dialog.h"

namespace proveout {

namespace {

QString text(const char* source) {
    return QCoreApplication::translate("SaveQuestion", source);
}

} // namespace

SaveAnswer askBeforeSave(QWidget& parent, const DiskConflict& conflict) {
    const QFileInfo file(toQString(conflict.file));
    QMessageBox question(
        QMessageBox::Warning, text(QT_TRANSLATE_NOOP("SaveQuestion", "File changed on disk")),
        text(QT_TRANSLATE_NOOP("SaveQuestion", "%1 has changed on disk.")).arg(file.fileName()),
        QMessageBox::Cancel, &parent);
    question.setTextFormat(Qt::PlainText); // the name comes from the user
    question.setInformativeText(
        text(QT_TRANSLATE_NOOP("SaveQuestion",
                               "Another program or window wrote it at %1. Saving here would overwrite those "
                               "changes.\n\nKeep Both saves your version as a new file in the same folder."))
            .arg(parent.locale().toString(file.lastModified(), QLocale::ShortFormat)));
    const QPushButton* overwrite = question.addButton(text(QT_TRANSLATE_NOOP("SaveQuestion", "&Overwrite")),
                                                      QMessageBox::DestructiveRole);
    const QPushButton* keepBoth =
        question.addButton(text(QT_TRANSLATE_NOOP("SaveQuestion", "&Keep Both")), QMessageBox::AcceptRole);
    QPushButton* compare =
        question.addButton(text(QT_TRANSLATE_NOOP("SaveQuestion", "&Compare…")), QMessageBox::ActionRole);
    compare->setEnabled(conflict.other.isKnown()); // otherwise it is too large to compare
    // The question stays open while the files are compared.
    compare->disconnect();
    QObject::connect(compare, &QPushButton::clicked, &question,
                     [&] { CompareDialog({comparisonOf(conflict)}, &question).exec(); });
    question.setDefaultButton(QMessageBox::Cancel);
    question.exec();
    if (question.clickedButton() == overwrite)
        return SaveAnswer::overwrite;
    return question.clickedButton() == keepBoth ? SaveAnswer::keepBoth : SaveAnswer::cancel;
}

bool mayReplaceStock(QWidget& parent, const StockShape& stock, const QString& file) {
    std::error_code error; // a file that does not exist yet is not in use
    if (stock.file.empty() || !std::filesystem::equivalent(stock.file, toPath(file), error))
        return true;
    QMessageBox question(QMessageBox::Warning, text(QT_TRANSLATE_NOOP("SaveQuestion", "Stock in use")),
                         text(QT_TRANSLATE_NOOP("SaveQuestion", "%1 is the stock of the open job."))
                             .arg(QFileInfo(file).fileName()),
                         QMessageBox::Cancel, &parent);
    question.setTextFormat(Qt::PlainText); // the name comes from the user
    question.setInformativeText(text(QT_TRANSLATE_NOOP(
        "SaveQuestion",
        "If you overwrite it, the job will start from its own result the next time it is opened.")));
    const QPushButton* overwrite = question.addButton(text(QT_TRANSLATE_NOOP("SaveQuestion", "&Overwrite")),
                                                      QMessageBox::DestructiveRole);
    question.setDefaultButton(QMessageBox::Cancel);
    question.exec();
    return question.clickedButton() == overwrite;
}

} // namespace proveout
