// SPDX-License-Identifier: GPL-3.0-or-later
// Number fields that never change a number silently.
#pragma once

#include <QDoubleSpinBox>
#include <QSpinBox>

namespace proveout {

/// The numbers that may be typed into a box.
template<class T>
struct NumberRange {
    T minimum;
    T maximum;
};

/// A spin box that accepts any number while typing. If the number is out of range when editing ends, the box
/// keeps its previous value, shows the allowed range next to itself and emits refused().
class NumberBox final : public QDoubleSpinBox {
    Q_OBJECT

public:
    explicit NumberBox(QWidget* parent = nullptr);

    /// Replaces QDoubleSpinBox::setRange(), whose range is also extended to any value that is shown.
    void setRange(double minimum, double maximum);
    [[nodiscard]] const NumberRange<double>& range() const { return m_range; }
    /// Shows a value that the program has set, even one out of range (e.g. from a file); emits nothing. Text
    /// that the user is typing is kept.
    void showValue(double value);
    [[nodiscard]] QValidator::State validate(QString& text, int& position) const override;
    void fixup(QString& text) const override;

signals:
    void refused(const QString& sentence) const;

private:
    NumberRange<double> m_range;
};

/// The same for whole numbers.
class CountBox final : public QSpinBox {
    Q_OBJECT

public:
    explicit CountBox(QWidget* parent = nullptr);

    void setRange(int minimum, int maximum);
    [[nodiscard]] const NumberRange<int>& range() const { return m_range; }
    void showValue(int value);
    [[nodiscard]] QValidator::State validate(QString& text, int& position) const override;
    void fixup(QString& text) const override;

signals:
    void refused(const QString& sentence) const;

private:
    NumberRange<int> m_range;
};

} // namespace proveout
