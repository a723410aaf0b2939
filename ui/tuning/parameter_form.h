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

/// One row per field of DecimationParameters that the method looks at, made from describe(): label, editor
/// with unit and range, and a button that brings the default back. Another method brings its own defaults,
/// where the values were those of the one before. Text that is no number never leaves an editor.
class ParameterForm final : public QWidget {
    Q_OBJECT

public:
    explicit ParameterForm(QWidget* parent = nullptr);

    [[nodiscard]] const DecimationParameters& values() const { return m_values; }
    /// Puts a row under the others, one that is no field of the struct, too; hands out its button, hidden.
    QToolButton* addRow(QLabel* label, QWidget* editor);
    /// Shows other values; emits nothing.
    void setValues(const DecimationParameters& values);
    /// The map has so many points, on which the default of the region size depends. Emits nothing.
    void setPoints(double points);

signals:
    void edited(const DecimationParameters& values);
    /// What was edited before and what comes next are two steps of the user, in the same field too.
    void stepEnded();

protected:
    void changeEvent(QEvent* event) override;

private:
    /// One field; its value passes as a double, whatever its type.
    struct Row {
        Field field;
        double defaultValue = 0;              ///< with the present method and map
        bool used = true;                     ///< the present method looks at it
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
    QWidget* makeEditor(Row& row); ///< for a value that is no choice
    QWidget* makeSwitch(Row& row);
    QWidget* makeInteger(Row& row);
    QWidget* makeNumber(Row& row);
    void place(std::size_t row);
    void reset(std::size_t row);
    void change(std::size_t row, double value);
    /// Standards and all rows, for the method of m_values.
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
