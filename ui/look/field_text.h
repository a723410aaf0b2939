// SPDX-License-Identifier: GPL-3.0-or-later
// Applies the description of a field (core/base/field.h) to a form. UI thread.
#pragma once

#include <QString>

#include "core/base/field.h"

class QLocale;
class QWidget;

namespace proveout {

class CountBox;
class NumberBox;

/// A number with the unit of the field: "5 blocks".
[[nodiscard]] QString fieldNumber(const Field& field, double value, const QLocale& locale);
/// Sets range, step and decimals of a box.
void setUpBox(NumberBox& box, const Field& field);
void setUpBox(CountBox& box, const Field& field);
/// Sets the name and tooltip of a field's editor in the current language, and for a box also the unit and the
/// range. `defaultText` is the default value and may be empty. Text that is being typed is kept.
void showFieldTexts(QWidget& editor, const Field& field, const QString& defaultText = {});

/// Writes the value of the box to `value`. A value that the box cannot show exactly (a stock of 12.7001 mm)
/// stays unchanged until it is edited.
void readShown(double& value, const NumberBox& box);

} // namespace proveout
