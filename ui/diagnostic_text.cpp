// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/diagnostic_text.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace proveout {

QString coreText(const char* text) {
    return text == nullptr || *text == '\0' ? QString() : QCoreApplication::translate("Core", text);
}

QString sentence(const Diagnostic& diagnostic) {
    const std::string text = coreText(diagnostic.text).toStdString();
    QString filled = QString::fromStdString(fillIn(text, diagnostic.arguments));
    // What is about another file than the open program names it.
    if (diagnostic.file.empty())
        return filled;
    return QStringLiteral("%1: %2").arg(QFileInfo(QString::fromStdString(diagnostic.file)).fileName(),
                                        filled);
}

QString hint(const Diagnostic& diagnostic) {
    const std::string text = coreText(diagnostic.hint).toStdString();
    return QString::fromStdString(fillIn(text, diagnostic.arguments));
}

QString severityName(Severity severity) {
    switch (severity) {
    case Severity::note:
        return QCoreApplication::translate("Severity", "Note");
    case Severity::warning:
        return QCoreApplication::translate("Severity", "Warning");
    case Severity::error:
        return QCoreApplication::translate("Severity", "Error");
    case Severity::fault:
        return QCoreApplication::translate("Severity", "Fault");
    }
    return {};
}

} // namespace proveout
