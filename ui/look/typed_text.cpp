// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/typed_text.h"

#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSpinBox>

namespace proveout {

bool isBeingTyped(const QSpinBox& box) {
    bool read = false;
    const int typed = box.locale().toInt(box.cleanText(), &read);
    return box.hasFocus() && (!read || typed != box.value());
}

/// Compares texts and not values, because "0." may be the beginning of another number than 0.
bool isBeingTyped(const QDoubleSpinBox& box) {
    return box.hasFocus() && box.cleanText() != box.textFromValue(box.value());
}

bool isBeingTyped(const QLineEdit& line) {
    return line.hasFocus() && line.isModified();
}

void showText(QLineEdit& line, const QString& text) {
    if (isBeingTyped(line) || line.text() == text)
        return;
    const QSignalBlocker quiet(&line);
    line.setText(text);
}

void finishTyping(QWidget& input) {
    if (auto* box = qobject_cast<QAbstractSpinBox*>(&input))
        box->interpretText();
    if (auto* line = qobject_cast<QLineEdit*>(&input); line != nullptr && isBeingTyped(*line))
        emit line->editingFinished(); // editing would not end otherwise, because the line keeps the focus
}

} // namespace proveout
