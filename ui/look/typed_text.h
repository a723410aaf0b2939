// SPDX-License-Identifier: GPL-3.0-or-later
// Text in an input that is not a value yet: it must not be changed until the user has finished it.
#pragma once

class QDoubleSpinBox;
class QLineEdit;
class QSpinBox;
class QString;
class QWidget;

namespace proveout {

/// Whether the box has the focus and contains text that differs from its value.
[[nodiscard]] bool isBeingTyped(const QSpinBox& box);
[[nodiscard]] bool isBeingTyped(const QDoubleSpinBox& box);
/// Whether the line has the focus and was edited since its text was set or editing finished.
[[nodiscard]] bool isBeingTyped(const QLineEdit& line);

/// Shows a text that the program has set, unless the user is typing another one. Emits nothing.
void showText(QLineEdit& line, const QString& text);

/// Commits the typed text as Return does, if `input` is a text or number field.
void finishTyping(QWidget& input);

} // namespace proveout
