// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/number_box.h"

#include <algorithm>
#include <optional>

#include <QCoreApplication>
#include <QSignalBlocker>
#include <QToolTip>

namespace proveout {

namespace {

/// What is between prefix and suffix.
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

template<class Box>
bool isOutOfRange(const Box& box, double value) {
    return value < box.minimum() || value > box.maximum();
}

/// A number that is not allowed may be on its way to one that is; and without its sign it would be another.
template<class Box>
QValidator::State stateOf(const Box& box, QValidator::State state, const QString& text) {
    if (state != QValidator::Invalid)
        return state;
    const auto typed = typedNumber(box, text);
    const bool begun = typedText(box, text) == box.locale().negativeSign();
    return begun || (typed && isOutOfRange(box, *typed)) ? QValidator::Intermediate : state;
}

/// The sentence of a refusal; empty where the text is no number out of range.
template<class Box>
QString refusal(const Box& box, const QString& text) {
    const auto typed = typedNumber(box, text);
    if (!typed || !isOutOfRange(box, *typed))
        return {};
    const auto shown = [&](double value) { return box.locale().toString(value, 'g', 9); };
    return QCoreApplication::translate("NumberBox", "%1 is out of range: %2 to %3%4.")
        .arg(shown(*typed), shown(box.minimum()), shown(box.maximum()), box.suffix());
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

} // namespace

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent) {
    setKeyboardTracking(false);
}

void NumberBox::showValue(double value) {
    const QSignalBlocker quiet(this);
    setRange(std::min(minimum(), value), std::max(maximum(), value));
    setValue(value);
}

QValidator::State NumberBox::validate(QString& text, int& position) const {
    return stateOf(*this, QDoubleSpinBox::validate(text, position), text);
}

void NumberBox::fixup(QString& text) const {
    refuse(*this, text);
    QDoubleSpinBox::fixup(text);
}

CountBox::CountBox(QWidget* parent) : QSpinBox(parent) {
    setKeyboardTracking(false);
}

void CountBox::showValue(int value) {
    const QSignalBlocker quiet(this);
    setRange(std::min(minimum(), value), std::max(maximum(), value));
    setValue(value);
}

QValidator::State CountBox::validate(QString& text, int& position) const {
    return stateOf(*this, QSpinBox::validate(text, position), text);
}

void CountBox::fixup(QString& text) const {
    refuse(*this, text);
    QSpinBox::fixup(text);
}

} // namespace proveout
