// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editor/word_tip.h"

#include <QCoreApplication>

#include "ui/diagnostic_text.h"

namespace proveout {

QString readableHelp(const WordHelp& help, DialectId dialectId) {
    const QString control = QString::fromUtf8(dialect(dialectId).name);
    const QString word = QString::fromStdString(help.word);
    if (help.name == nullptr)
        return QCoreApplication::translate("WordTip", "%1: not known on %2").arg(word, control);
    QString text =
        QCoreApplication::translate("WordTip", "%1: %2 (%3)").arg(word, coreText(help.name), control);
    if (help.group != nullptr)
        text += u'\n' + QCoreApplication::translate("WordTip", "Modal group: %1").arg(coreText(help.group));
    if (!help.supported)
        text += u'\n' + QCoreApplication::translate("WordTip",
                                                    "Not carried out: the program is unverified from here");
    return text;
}

} // namespace proveout
