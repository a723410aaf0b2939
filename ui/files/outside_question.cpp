// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/files/outside_question.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include "ui/document/file_paths.h"

namespace proveout {

namespace {

QString text(const char* source) {
    return QCoreApplication::translate("OutsideQuestion", source);
}

} // namespace

bool mayReadOutside(QWidget& parent, const QString& jobFile,
                    const std::vector<std::filesystem::path>& files) {
    QString sentence = text(QT_TRANSLATE_NOOP("OutsideQuestion", "%1 uses files outside its folder:"))
                           .arg(QFileInfo(jobFile).fileName());
    for (const std::filesystem::path& file : files)
        sentence += QLatin1Char('\n') + toQString(file);
    QMessageBox question(QMessageBox::Warning,
                         text(QT_TRANSLATE_NOOP("OutsideQuestion", "Files outside the folder of the job")),
                         sentence, QMessageBox::Cancel, &parent);
    question.setTextFormat(Qt::PlainText); // the names come from the job
    question.setInformativeText(
        text(QT_TRANSLATE_NOOP("OutsideQuestion", "Allow this only if you trust the job. Your answer is "
                                                  "remembered for this job and these files.")));
    const QPushButton* allow = question.addButton(
        text(QT_TRANSLATE_NOOP("OutsideQuestion", "&Allow and Open")), QMessageBox::AcceptRole);
    question.setDefaultButton(QMessageBox::Cancel);
    question.exec();
    return question.clickedButton() == allow;
}

} // namespace proveout
