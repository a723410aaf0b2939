// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/diagnostic_text.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include <QCoreApplication>
#include <QFileInfo>

#include "core/base/list_argument.h"

namespace proveout {

namespace {

/// Arguments are words of the user's file, figures, keys, or texts of the core, e.g. the name of a code. Only
/// the last are in the catalogue.
std::string translated(const std::string& argument) {
    if (argument.find('\0') != std::string::npos)
        return argument;
    return changedList(argument, kListSeparator, [](std::string_view part) {
        return coreText(std::string(part).c_str()).toStdString();
    });
}

} // namespace

QString coreText(const char* text) {
    return text == nullptr || *text == '\0' ? QString() : QCoreApplication::translate("Core", text);
}

QString coreText(const char* text, std::vector<std::string> arguments) {
    std::ranges::transform(arguments, arguments.begin(), translated);
    return QString::fromStdString(fillIn(coreText(text).toStdString(), arguments));
}

QString sentence(const Diagnostic& diagnostic) {
    QString text = coreText(diagnostic.text, diagnostic.arguments);
    // What is about another file than the open program names it.
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
