// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <QWidget>

#include "core/formats/stock_shapes.h"
#include "core/simulation/setup/setup.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QToolButton;

namespace proveout {

class GridField;
class NumberBox;

/// Shape, size and position of the stock, and the grid. The fields of each shape come from the table of
/// shapes.
class StockForm final : public QWidget {
    Q_OBJECT

public:
    explicit StockForm(QWidget* parent = nullptr);
    /// Shows the values of the setup; emits nothing.
    void show(const Setup& setup);
    /// Writes position and grid to `setup`.
    void put(Setup& setup) const;
    /// The stock described by the form, based on `setup`; without a body if that of `setup` does not match
    /// the description.
    [[nodiscard]] StockSpec spec(const Setup& setup) const;

signals:
    void edited();

protected:
    void changeEvent(QEvent* event) override;

private:
    /// A field of one shape; its type of value decides which of the editors is used.
    struct ShapeField {
        StockKind kind;
        const StockField* field;
        QLabel* label;
        QWidget* editor;
        NumberBox* length = nullptr;
        QComboBox* choice = nullptr;
        QLineEdit* file = nullptr;
        QToolButton* browse = nullptr;
    };

    void addShapes(QGridLayout& layout);
    void addField(QGridLayout& layout, const StockShapeRow& row, const StockField& field);
    QWidget* fileEditor(ShapeField& row);
    void chooseFile(const ShapeField& row);
    void addRow(QGridLayout& layout, QLabel* label, QWidget* editor);
    NumberBox* lengthBox(const QString& name, double minimum, double maximum);
    void showFieldsOfShape();
    void retranslate();
    void retranslateShapes();
    [[nodiscard]] QString rangeTip(const QString& help, const NumberBox& box, double defaultValue) const;

    QLabel* m_shapeLabel;
    QComboBox* m_shape;
    std::vector<ShapeField> m_fields;
    std::vector<QLabel*> m_labels;   ///< of the position
    std::vector<NumberBox*> m_boxes; ///< same order as their table
    QLabel* m_gridLabel;
    GridField* m_grid;
};

} // namespace proveout
