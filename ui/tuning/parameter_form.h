// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <QWidget>

#include "core/base/field.h"
#include "core/decimation/regions/parameters.h"

class QFormLayout;
class QLabel;
class QToolButton;

namespace proveout {

/// One row per field of DecimationParameters that the method uses, created from describe(): label, editor
/// with unit and range, and a button that resets it to the default. Changing the method sets its defaults for
/// values that had the previous method's defaults. Text that is not a number is never adopted.
class ParameterForm final : public QWidget {
    Q_OBJECT

public:
    explicit ParameterForm(QWidget* parent = nullptr);

    [[nodiscard]] const DecimationParameters& values() const { return m_values; }
    /// Adds a row below the others, also one that is not a field of the struct; returns its button, hidden.
    QToolButton* addRow(QLabel* label, QWidget* editor);
    /// Shows other values; emits nothing.
    void setValues(const DecimationParameters& values);
    /// Sets the number of points of the z-map, on which the default of the region size depends. Emits
    /// nothing.
    void setPoints(double points);

signals:
    void edited(const DecimationParameters& values);
    /// Changes before and after this are two undo steps, even in the same field.
    void stepEnded();

protected:
    void changeEvent(QEvent* event) override;

private:
    /// One field; its value is passed as a double, whatever its type.
    struct Row {
        Field field;
        double defaultValue = 0;              ///< for the current method and z-map
        bool used = true;                     ///< whether the current method uses it
        std::function<double()> value;        ///< in m_values
        std::function<void(double)> setValue; ///< in m_values
        std::function<void(double)> show;     ///< in the editor
        QLabel* label = nullptr;
        QWidget* editor = nullptr;
        QToolButton* reset = nullptr;
    };

    template<class T>
    void addRow(T& place, const Field& field);
    QWidget* makeChoices(Row& row);
    template<class T>
    QWidget* makeEditor(Row& row); ///< for a value without choices
    QWidget* makeSwitch(Row& row);
    QWidget* makeInteger(Row& row);
    QWidget* makeNumber(Row& row);
    void place(std::size_t row);
    void reset(std::size_t row);
    void change(std::size_t row, double value);
    /// Updates defaults and all rows for the method of m_values.
    void showMethod();
    void findDefaults();
    void showRow(const Row& row);
    void retranslate();
    [[nodiscard]] QString valueText(const Row& row, double value) const;

    QFormLayout* m_layout;
    DecimationParameters m_values;
    double m_points = 0;
    std::vector<Row> m_rows;
};

} // namespace proveout
