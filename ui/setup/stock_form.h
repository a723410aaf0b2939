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

/// Shape, size and place of the stock, and the grid. The fields of the shapes are read from their table.
class StockForm final : public QWidget {
    Q_OBJECT

public:
    explicit StockForm(QWidget* parent = nullptr);
    /// Shows other values; emits nothing.
    void show(const Setup& setup);
    /// Puts position and grid into `setup`.
    void put(Setup& setup) const;
    /// What the form describes, on the ground of `setup`; it has no body where that of `setup` is of another
    /// description.
    [[nodiscard]] StockSpec spec(const Setup& setup) const;

signals:
    void edited();

protected:
    void changeEvent(QEvent* event) override;

private:
    /// A field of one shape; one of the editors, by its value.
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
    std::vector<NumberBox*> m_boxes; ///< in the order of their table
    QLabel* m_gridLabel;
    GridField* m_grid;
};

} // namespace proveout
