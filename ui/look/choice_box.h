// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>

namespace proveout {

/// A combo box in which the longest choice can be read to its end, in another language too.
class ChoiceBox final : public QComboBox {
public:
    explicit ChoiceBox(QWidget* parent = nullptr) : QComboBox(parent) {
        setSizeAdjustPolicy(AdjustToContents);
    }

    /// Qt's own remembers the texts of the language before.
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }
};

} // namespace proveout
