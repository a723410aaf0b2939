// SPDX-License-Identifier: GPL-3.0-or-later
// Number fields that never change a number in silence.
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

/// A spin box that lets any number be typed. Where it is out of range when the editing ends, the box keeps
/// the value it had, says so beside itself, with the range, and emits refused().
class NumberBox final : public QDoubleSpinBox {
    Q_OBJECT

public:
    explicit NumberBox(QWidget* parent = nullptr);

    /// In the place of QDoubleSpinBox::setRange(), whose range also takes in a value that is shown.
    void setRange(double minimum, double maximum);
    [[nodiscard]] const NumberRange<double>& range() const { return m_range; }
    /// Shows a value that others have set, also one out of the range (of a file, say); emits nothing. Text
    /// that the user is typing stays.
    void showValue(double value);
    [[nodiscard]] QValidator::State validate(QString& text, int& position) const override;
    void fixup(QString& text) const override;

signals:
    void refused(const QString& sentence) const;

private:
    NumberRange<double> m_range;
};

/// The same of whole numbers.
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
