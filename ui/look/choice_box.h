// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>

namespace proveout {

/// A combo box wide enough for its longest choice, in any language.
class ChoiceBox final : public QComboBox {
public:
    explicit ChoiceBox(QWidget* parent = nullptr) : QComboBox(parent) {
        setSizeAdjustPolicy(AdjustToContents);
    }

    /// Qt's own hint still has the width of the texts in the previous language.
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }
};

} // namespace proveout
