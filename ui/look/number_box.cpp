// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/number_box.h"

#include <algorithm>
#include <optional>

#include <QCoreApplication>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QToolTip>

#include "ui/look/typed_text.h"

namespace proveout {

namespace {

/// The text between prefix and suffix.
template<class Box>
QString typedText(const Box& box, const QString& text) {
    QString typed = text;
    if (typed.startsWith(box.prefix()))
        typed.remove(0, box.prefix().size());
    if (const QString suffix = box.suffix(); !suffix.isEmpty() && typed.endsWith(suffix))
        typed.chop(suffix.size());
    return typed.trimmed();
}

template<class Box>
std::optional<double> typedNumber(const Box& box, const QString& text) {
    bool read = false;
    const double value = box.locale().toDouble(typedText(box, text), &read);
    return read ? std::optional(value) : std::nullopt;
}

/// A value that the box already shows is always accepted, even if it was set outside the range.
template<class Box>
bool isOutOfRange(const Box& box, double value) {
    const bool outside = value < box.range().minimum || value > box.range().maximum;
    return outside && value != static_cast<double>(box.value());
}

/// A number out of range may become valid with the next key. A minus sign alone is accepted too, because -5
/// would become 5 without it.
template<class Box>
QValidator::State stateOf(const Box& box, QValidator::State state, const QString& text) {
    const auto typed = typedNumber(box, text);
    if (typed && isOutOfRange(box, *typed))
        return QValidator::Intermediate;
    const bool begun = typedText(box, text) == box.locale().negativeSign();
    return begun && state == QValidator::Invalid ? QValidator::Intermediate : state;
}

/// The message for a refused number; empty if the text is not a number out of range.
template<class Box>
QString refusal(const Box& box, const QString& text) {
    const auto typed = typedNumber(box, text);
    if (!typed || !isOutOfRange(box, *typed))
        return {};
    const auto shown = [&](double value) { return box.locale().toString(value, 'g', 9); };
    return QCoreApplication::translate("NumberBox", "%1 is out of range: %2 to %3%4.")
        .arg(shown(*typed), shown(box.range().minimum), shown(box.range().maximum), box.suffix());
}

template<class Box>
void refuse(const Box& box, const QString& text) {
    const QString sentence = refusal(box, text);
    if (sentence.isEmpty())
        return;
    if (box.isVisible())
        QToolTip::showText(box.mapToGlobal(QPoint(0, box.height())), sentence);
    emit box.refused(sentence);
}

bool isShown(const NumberBox& box, double value) {
    return box.textFromValue(value) == box.textFromValue(box.value());
}

bool isShown(const CountBox& box, int value) {
    return value == box.value();
}

/// `Base` is Qt's own box, whose range must include the value. `line` is the editor of the box.
template<class Base, class Box, class T>
void showIn(Box& box, QLineEdit& line, T value) {
    const QSignalBlocker quiet(&box);
    const bool typing = isBeingTyped(box);
    if (typing && isShown(box, value))
        return; // keeps the undo history of the text
    const QString typed = line.text();
    const int cursor = line.cursorPosition();
    box.Base::setRange(std::min<T>(box.range().minimum, value), std::max<T>(box.range().maximum, value));
    box.setValue(value);
    if (!typing)
        return;
    line.setText(typed);
    line.setCursorPosition(cursor);
}

} // namespace

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent), m_range{minimum(), maximum()} {
    setKeyboardTracking(false);
}

void NumberBox::setRange(double minimum, double maximum) {
    m_range = {minimum, maximum};
    QDoubleSpinBox::setRange(minimum, maximum);
}

void NumberBox::showValue(double value) {
    showIn<QDoubleSpinBox>(*this, *lineEdit(), value);
}

QValidator::State NumberBox::validate(QString& text, int& position) const {
    return stateOf(*this, QDoubleSpinBox::validate(text, position), text);
}

void NumberBox::fixup(QString& text) const {
    refuse(*this, text);
    QDoubleSpinBox::fixup(text);
}

CountBox::CountBox(QWidget* parent) : QSpinBox(parent), m_range{minimum(), maximum()} {
    setKeyboardTracking(false);
}

void CountBox::setRange(int minimum, int maximum) {
    m_range = {minimum, maximum};
    QSpinBox::setRange(minimum, maximum);
}

void CountBox::showValue(int value) {
    showIn<QSpinBox>(*this, *lineEdit(), value);
}

QValidator::State CountBox::validate(QString& text, int& position) const {
    return stateOf(*this, QSpinBox::validate(text, position), text);
}

void CountBox::fixup(QString& text) const {
    refuse(*this, text);
    QSpinBox::fixup(text);
}

} // namespace proveout
