// SPDX-License-Identifier: GPL-3.0-or-later
// What a form takes of the description of a field (core/base/field.h). UI thread.
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
/// Range, step and decimals of a box.
void setUpBox(NumberBox& box, const Field& field);
void setUpBox(CountBox& box, const Field& field);
/// Name and tool tip of the editor of a field, in the language of the moment; of a box the unit and the
/// range, too. `standard` is its default, which may be left out. Text that is being typed stays.
void showFieldTexts(QWidget& editor, const Field& field, const QString& defaultText = {});

/// Puts what the box shows into `value`. What the box cannot show exactly (a stock of 12.7001 mm) stays as it
/// is until it is edited.
void readShown(double& value, const NumberBox& box);

} // namespace proveout
