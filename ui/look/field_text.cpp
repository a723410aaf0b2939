// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/field_text.h"

#include <cmath>

#include <QAbstractSpinBox>
#include <QCoreApplication>
#include <QLocale>
#include <QWidget>

#include "ui/look/diagnostic_text.h"
#include "ui/look/number_box.h"

namespace proveout {

namespace {

/// The units that are words; the core does not mark them for translation.
[[maybe_unused]] constexpr const char* kUnitWords[] = {QT_TRANSLATE_NOOP("Core", "cells"),
                                                       QT_TRANSLATE_NOOP("Core", "blocks")};

QString suffixOf(const Field& field) {
    return *field.unit == '\0' ? QString() : u' ' + coreText(field.unit);
}

QString plainNumber(double value, const QLocale& locale) {
    return locale.toString(value, 'f', QLocale::FloatingPointShortest);
}

/// Setting a suffix, even the same one, would replace the text that is being typed by the value.
template<class Box>
void showSuffix(Box& box, const Field& field) {
    if (const QString text = suffixOf(field); box.suffix() != text)
        box.setSuffix(text);
}

QString rangeText(const Field& field, const QLocale& locale) {
    return QCoreApplication::translate("Field", "Range: %1 to %2", "the second one with its unit")
        .arg(plainNumber(field.minimum, locale), fieldNumber(field, field.maximum, locale));
}

} // namespace

QString fieldNumber(const Field& field, double value, const QLocale& locale) {
    return plainNumber(value, locale) + suffixOf(field);
}

void setUpBox(NumberBox& box, const Field& field) {
    box.setDecimals(field.decimals);
    box.setRange(field.minimum, field.maximum);
    box.setSingleStep(field.step);
}

void setUpBox(CountBox& box, const Field& field) {
    box.setRange(static_cast<int>(field.minimum), static_cast<int>(field.maximum));
    box.setSingleStep(static_cast<int>(field.step));
}

void showFieldTexts(QWidget& editor, const Field& field, const QString& defaultText) {
    QString tip = *field.help == '\0' ? coreText(field.label) : coreText(field.help);
    if (qobject_cast<QAbstractSpinBox*>(&editor) != nullptr)
        tip += u'\n' + rangeText(field, editor.locale());
    if (!defaultText.isEmpty())
        tip += u'\n' + QCoreApplication::translate("Field", "Default: %1").arg(defaultText);
    editor.setToolTip(tip);
    editor.setAccessibleName(coreText(field.label));
    if (auto* number = qobject_cast<NumberBox*>(&editor))
        showSuffix(*number, field);
    if (auto* count = qobject_cast<CountBox*>(&editor))
        showSuffix(*count, field);
}

void readShown(double& value, const NumberBox& box) {
    if (std::abs(value - box.value()) > 0.5 * std::pow(10.0, -box.decimals()))
        value = box.value();
}

} // namespace proveout
