// SPDX-License-Identifier: GPL-3.0-or-later
// Text in an input that is no value yet: it belongs to the user until it is finished.
#pragma once

class QDoubleSpinBox;
class QLineEdit;
class QSpinBox;
class QString;
class QWidget;

namespace proveout {

/// Whether the box has the focus and holds text that is not its value.
[[nodiscard]] bool isBeingTyped(const QSpinBox& box);
[[nodiscard]] bool isBeingTyped(const QDoubleSpinBox& box);
/// Whether the line has the focus and was edited since its text was set or finished.
[[nodiscard]] bool isBeingTyped(const QLineEdit& line);

/// Shows a text that others have set, unless the user is typing another one. Emits nothing.
void showText(QLineEdit& line, const QString& text);

/// Makes the typed text the value of its input, as Return does, where `input` is one that is typed in.
void finishTyping(QWidget& input);

} // namespace proveout
