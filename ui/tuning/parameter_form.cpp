// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/parameter_form.h"

#include <cmath>
#include <map>
#include <string_view>
#include <type_traits>

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>

#include "core/decimation/regions/region_decimator.h"
#include "ui/look/choice_box.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/field_text.h"
#include "ui/look/icons.h"
#include "ui/look/number_box.h"
#include "ui/look/typed_text.h"

namespace proveout {

namespace {

constexpr int kBoxWidth = 90; // a box's default would fit the largest number of its range

} // namespace

template<class T>
QWidget* ParameterForm::makeEditor(Row& row) {
    if constexpr (std::is_same_v<T, bool>)
        return makeSwitch(row);
    if constexpr (std::is_integral_v<T>)
        return makeInteger(row);
    return makeNumber(row);
}

template<class T>
void ParameterForm::addRow(T& place, const Field& field) {
    Row row;
    row.field = field;
    row.value = [&place] { return static_cast<double>(place); };
    row.setValue = [&place](double value) {
        if constexpr (std::is_enum_v<T>)
            place = static_cast<T>(static_cast<int>(value));
        else
            place = static_cast<T>(value);
    };
    row.editor = field.choices.empty() ? makeEditor<T>(row) : makeChoices(row);
    m_rows.push_back(std::move(row));
}

ParameterForm::ParameterForm(QWidget* parent) : QWidget(parent), m_layout(new QFormLayout(this)) {
    describe(m_values, [this](auto& place, const Field& field) { addRow(place, field); });
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    // In a narrow panel an editor with long choices moves below its label, so that it remains readable.
    m_layout->setRowWrapPolicy(QFormLayout::WrapLongRows);
    for (std::size_t i = 0; i < m_rows.size(); ++i)
        place(i);
    showMethod();
}

void ParameterForm::findDefaults() {
    const DecimationParameters untouched;
    DecimationParameters defaults;
    defaults.method = m_values.method;
    useDefaults(defaults, false, false, m_points);
    defaults.method = untouched.method;
    std::map<std::string_view, double> values;
    describe(defaults,
             [&](const auto& value, const Field& field) { values[field.key] = static_cast<double>(value); });
    for (Row& row : m_rows)
        row.defaultValue = values[row.field.key];
}

QWidget* ParameterForm::makeChoices(Row& row) {
    auto* box = new ChoiceBox(this);
    for (const Choice& choice : row.field.choices)
        box->addItem(QString(), QLatin1String(choice.key));
    const std::size_t index = m_rows.size();
    connect(box, &QComboBox::activated, this, [this, index](int chosen) { change(index, chosen); });
    row.show = [box](double value) { box->setCurrentIndex(static_cast<int>(value)); };
    return box;
}

QWidget* ParameterForm::makeSwitch(Row& row) {
    auto* box = new QCheckBox(this);
    const std::size_t index = m_rows.size();
    connect(box, &QCheckBox::toggled, this, [this, index](bool on) { change(index, on ? 1 : 0); });
    row.show = [box](double value) { box->setChecked(value != 0); };
    return box;
}

QWidget* ParameterForm::makeInteger(Row& row) {
    auto* box = new CountBox(this);
    setUpBox(*box, row.field);
    const std::size_t index = m_rows.size();
    connect(box, &QSpinBox::valueChanged, this, [this, index](int value) { change(index, value); });
    row.show = [box](double value) { box->showValue(static_cast<int>(value)); };
    return box;
}

QWidget* ParameterForm::makeNumber(Row& row) {
    auto* box = new NumberBox(this);
    setUpBox(*box, row.field);
    const std::size_t index = m_rows.size();
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, index](double value) { change(index, value); });
    row.show = [box](double value) { box->showValue(value); };
    return box;
}

QToolButton* ParameterForm::addRow(QLabel* label, QWidget* editor) {
    auto* reset = new QToolButton(this);
    reset->setAutoRaise(true);
    reset->setIcon(icon(QStringLiteral("undo")));
    reset->hide();
    QSizePolicy policy = reset->sizePolicy();
    policy.setRetainSizeWhenHidden(true); // keeps the editors aligned
    reset->setSizePolicy(policy);
    if (qobject_cast<QAbstractSpinBox*>(editor) != nullptr)
        editor->setMinimumWidth(kBoxWidth);
    auto* field = new QHBoxLayout;
    field->addWidget(editor, 1);
    field->addWidget(reset);
    label->setBuddy(editor);
    m_layout->addRow(label, field);
    return reset;
}

void ParameterForm::place(std::size_t index) {
    Row& row = m_rows[index];
    row.label = new QLabel(this);
    row.editor->setObjectName(QLatin1String(row.field.key));
    row.reset = addRow(row.label, row.editor);
    connect(row.reset, &QToolButton::clicked, this, [this, index] { reset(index); });
}

/// Clicking the button does not move the focus, so typed text is committed first and becomes an undo step.
void ParameterForm::reset(std::size_t row) {
    finishTyping(*m_rows[row].editor);
    emit stepEnded();
    change(row, m_rows[row].defaultValue);
    emit stepEnded();
}

void ParameterForm::setValues(const DecimationParameters& values) {
    const bool otherMethod = values.method != m_values.method;
    m_values = values;
    if (otherMethod)
        showMethod();
    for (const Row& row : m_rows)
        showRow(row);
}

void ParameterForm::setPoints(double points) {
    m_points = points;
    showMethod();
    for (const Row& row : m_rows)
        showRow(row);
}

void ParameterForm::showMethod() {
    findDefaults();
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        m_rows[i].used = proveout::row(m_values.method).uses(m_rows[i].field.key);
        m_layout->setRowVisible(static_cast<int>(i), m_rows[i].used);
    }
    retranslate(); // the tooltips contain the default values
}

void ParameterForm::showRow(const Row& row) {
    const QSignalBlocker quiet(row.editor);
    row.show(row.value());
    row.reset->setVisible(row.used && row.value() != row.defaultValue);
}

void ParameterForm::change(std::size_t row, double value) {
    const DecimationMethodRow& before = proveout::row(m_values.method);
    m_rows[row].setValue(value);
    if (m_values.method != before.method) {
        useDefaults(m_values, m_values.regionCells != defaultRegion(before.method, m_points),
                    m_values.period != before.defaultPeriod, m_points);
        showMethod();
    }
    showRow(m_rows[row]);
    emit edited(m_values);
}

QString ParameterForm::valueText(const Row& row, double value) const {
    if (!row.field.choices.empty())
        return coreText(row.field.choices[static_cast<std::size_t>(value)].label);
    if (qobject_cast<QCheckBox*>(row.editor) != nullptr)
        return value != 0 ? tr("on") : tr("off");
    return fieldNumber(row.field, value, locale());
}

void ParameterForm::retranslate() {
    for (const Row& row : m_rows) {
        row.label->setText(coreText(row.field.label));
        showFieldTexts(*row.editor, row.field, valueText(row, row.defaultValue));
        row.label->setToolTip(row.editor->toolTip());
        row.reset->setToolTip(tr("Back to the default: %1").arg(valueText(row, row.defaultValue)));
        row.reset->setAccessibleName(tr("Reset %1").arg(coreText(row.field.label)));
        if (auto* box = qobject_cast<QComboBox*>(row.editor)) {
            for (int i = 0; i < box->count(); ++i)
                box->setItemText(i, coreText(row.field.choices[static_cast<std::size_t>(i)].label));
        }
        showRow(row);
    }
}

void ParameterForm::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace proveout
