// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/setup/tool_form.h"

#include <QDoubleSpinBox>
#include <QEvent>
#include <QFormLayout>
#include <QSignalBlocker>

#include "ui/choice_box.h"
#include "ui/diagnostic_text.h"

namespace proveout {

namespace {
constexpr int kBoxWidth = 110;
}

ToolForm::ToolForm(QWidget* parent)
    : QWidget(parent), m_spec(standardSpec()), m_shape(new ChoiceBox(this)), m_layout(new QFormLayout(this)) {
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setRowWrapPolicy(QFormLayout::WrapLongRows);
    for (const CutterShape& shape : cutterShapes())
        m_shape->addItem(QString(), QLatin1String(shape.key));
    m_layout->addRow(tr("Shape"), m_shape);
    connect(m_shape, &QComboBox::activated, this, &ToolForm::chooseShape);
    nameShapes();
    build();
}

void ToolForm::nameShapes() {
    m_shape->setAccessibleName(tr("Shape"));
    m_shape->setToolTip(tr("The profile of the cutter"));
    for (int i = 0; i < m_shape->count(); ++i)
        m_shape->setItemText(i, coreText(cutterShapes()[static_cast<std::size_t>(i)].label));
}

void ToolForm::show(const ToolSpec& spec) {
    const bool sameKeys = spec.shape == m_spec.shape;
    m_spec = spec;
    m_shape->setCurrentIndex(m_shape->findData(QString::fromStdString(shapeRow(spec.shape).key)));
    if (!sameKeys) {
        build();
        return;
    }
    for (const auto& [key, value] : m_spec.values) {
        if (auto* box = findChild<QDoubleSpinBox*>(QString::fromStdString("tool-" + key))) {
            const QSignalBlocker quiet(box);
            box->setValue(value);
        }
    }
}

void ToolForm::chooseShape(int index) {
    ToolSpec chosen = readSpec(cutterShapes()[static_cast<std::size_t>(index)].key);
    for (auto& [key, value] : chosen.values) {
        // What both shapes have (diameter, lengths) stays.
        if (const auto before = m_spec.values.find(key); before != m_spec.values.end())
            value = before->second;
    }
    m_spec = std::move(chosen);
    build();
    emit edited();
}

void ToolForm::build() {
    while (m_layout->rowCount() > 1)
        m_layout->removeRow(1);
    m_shape->setCurrentIndex(m_shape->findData(QString::fromStdString(shapeRow(m_spec.shape).key)));
    for (const ShapeKey& key : keysOf(m_spec.shape))
        addKey(key);
}

void ToolForm::addKey(const ShapeKey& key) {
    auto* box = new QDoubleSpinBox(this);
    box->setObjectName(QStringLiteral("tool-") + QLatin1String(key.key));
    box->setDecimals(3);
    box->setRange(key.minimum, key.maximum);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setKeyboardTracking(false);
    box->setMinimumWidth(kBoxWidth);
    box->setSuffix(u' ' + coreText(key.unit));
    box->setValue(m_spec.values[key.key]);
    box->setAccessibleName(coreText(key.label));
    const QString unit = coreText(key.unit);
    box->setToolTip(tr("%1\nRange: %2 to %3 %4\nDefault: %5 %4")
                        .arg(coreText(key.label), locale().toString(key.minimum),
                             locale().toString(key.maximum), unit, locale().toString(key.standard)));
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, name = std::string(key.key)](double value) {
        m_spec.values[name] = value;
        emit edited();
    });
    m_layout->addRow(coreText(key.label), box);
}

void ToolForm::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() != QEvent::LanguageChange)
        return;
    if (auto* label = qobject_cast<QWidget*>(m_layout->labelForField(m_shape)))
        label->setProperty("text", tr("Shape"));
    nameShapes();
    build();
}

} // namespace proveout
