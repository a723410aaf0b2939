// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/diagnostic_text.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include <QCoreApplication>
#include <QFileInfo>
#include <QLocale>

#include "core/base/list_argument.h"

namespace proveout {

namespace {

/// Arguments are figures, words of the user's file, keys, or texts of the core such as the name of a code.
/// Only the last are in the catalogue.
std::string shown(const Argument& argument) {
    if (argument.isFigures())
        return figuresText(argument).toStdString();
    if (argument.text().find('\0') != std::string::npos)
        return argument;
    return changedList(argument.text(), kListSeparator, [](std::string_view part) {
        return coreText(std::string(part).c_str()).toStdString();
    });
}

} // namespace

QString coreText(const char* text) {
    return text == nullptr || *text == '\0' ? QString() : QCoreApplication::translate("Core", text);
}

QString coreText(const char* text, const std::vector<Argument>& arguments) {
    std::vector<std::string> texts;
    std::ranges::transform(arguments, std::back_inserter(texts), shown);
    return QString::fromStdString(fillIn(coreText(text).toStdString(), texts));
}

QString figuresText(const std::string& figures) {
    return QString::fromStdString(figures).replace(u'.', QLocale().decimalPoint());
}

QString sentence(const Diagnostic& diagnostic) {
    QString text = coreText(diagnostic.text, diagnostic.arguments);
    // A problem in a file other than the open program names that file.
    if (diagnostic.file.empty())
        return text;
    return QStringLiteral("%1: %2").arg(QFileInfo(QString::fromStdString(diagnostic.file)).fileName(), text);
}

QString hint(const Diagnostic& diagnostic) {
    return coreText(diagnostic.hint, diagnostic.arguments);
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
        return QCoreApplication::translate("Severity", "Machining fault");
    }
    return {};
}

} // namespace proveout
