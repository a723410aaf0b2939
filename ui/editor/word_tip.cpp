// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editor/word_tip.h"

#include <algorithm>
#include <cstring>

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include "ui/look/diagnostic_text.h"

namespace proveout {

QString readableHelp(const WordHelp& help, DialectId dialectId) {
    QStringList lines;
    for (const HelpSentence& sentence : helpSentences(help, dialectId))
        lines += coreText(sentence.text, sentence.arguments);
    return lines.join(u'\n');
}

namespace {

constexpr int kDigits = 9;

QString shown(double value) {
    return QLocale().toString(value, 'g', kDigits);
}

QString valueText(const WordHelp& help, const LineValues& values) {
    const auto value = std::ranges::find(values.words, help.begin, &LineValues::Value::begin);
    if (value == values.words.end())
        return {};
    QString text = shown(value->value);
    if (const QString unit = coreText(value->unit); !unit.isEmpty())
        text += QStringLiteral(" ") + unit;
    constexpr double kMmPerInch = 25.4;
    if (std::strcmp(value->unit, "in") == 0)
        text += QStringLiteral(" (%1 mm)").arg(shown(value->value * kMmPerInch));
    return QCoreApplication::translate("WordTip", "Value: %1").arg(text);
}

QString parameterText(const WordHelp& help, const LineValues& values) {
    const auto parameter = std::ranges::find(values.parameters, help.begin, &LineValues::Parameter::begin);
    if (parameter == values.parameters.end())
        return {};
    QString before = parameter->before
                         ? QCoreApplication::translate("WordTip", "Value: %1").arg(shown(*parameter->before))
                         : QCoreApplication::translate("WordTip", "Not set");
    if (parameter->before == parameter->after || !parameter->after)
        return before;
    return before + u'\n' +
           QCoreApplication::translate("WordTip", "After this line: %1").arg(shown(*parameter->after));
}

/// "G54 (work offset 1)"; several if a group has several.
QString modesOf(const std::vector<ControlState::Mode>& modes, const char* group) {
    QStringList texts;
    for (const ControlState::Mode& mode : modes)
        if (std::strcmp(mode.group, group) == 0)
            texts += QStringLiteral("%1 (%2)").arg(QString::fromStdString(mode.code), coreText(mode.name));
    return texts.join(QStringLiteral(", "));
}

QString codesText(const WordHelp& help, const LineValues& values) {
    const QString before = modesOf(values.before, help.group);
    const QString after = modesOf(values.after, help.group);
    if (before.isEmpty() && after.isEmpty())
        return {};
    if (before == after)
        return QCoreApplication::translate("WordTip", "Active before and after: %1").arg(before);
    return QCoreApplication::translate("WordTip", "Active before: %1").arg(before) + u'\n' +
           QCoreApplication::translate("WordTip", "After this line: %1").arg(after);
}

} // namespace

QString readableValues(const WordHelp& help, const LineValues& values) {
    if (values.executions == 0)
        return QCoreApplication::translate("WordTip", "This line is not executed");
    QString text = help.parameter          ? parameterText(help, values)
                   : help.group != nullptr ? codesText(help, values)
                                           : valueText(help, values);
    if (!text.isEmpty() && values.executions > 1)
        text += u'\n' + QCoreApplication::translate("WordTip", "First of %1 executions")
                            .arg(QLocale().toString(static_cast<qulonglong>(values.executions)));
    return text;
}

} // namespace proveout
