// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/setup/tool_form.h"

#include <algorithm>
#include <string_view>

#include <QDoubleSpinBox>
#include <QEvent>
#include <QFormLayout>
#include <QLineEdit>

#include "ui/look/choice_box.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/number_box.h"
#include "ui/look/typed_text.h"

namespace proveout {

namespace {

constexpr int kBoxWidth = 114;

QString nameOf(const std::string& key) {
    return QString::fromStdString("tool-" + key);
}

/// The key of a shape; null if it has no key with this name, or one with another meaning.
const ShapeKey* sameKey(const std::vector<ShapeKey>& keys, const ShapeKey& wanted) {
    const auto found = std::ranges::find_if(keys, [&](const ShapeKey& key) {
        return std::string_view(key.key) == wanted.key && std::string_view(key.label) == wanted.label;
    });
    return found == keys.end() ? nullptr : &*found;
}

} // namespace

ToolForm::ToolForm(QWidget* parent)
    : QWidget(parent), m_spec(defaultSpec()), m_shape(new ChoiceBox(this)), m_layout(new QFormLayout(this)) {
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
    m_shape->setToolTip(tr("Cutter shape"));
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
    for (const auto& [key, value] : m_spec.values)
        showNumber(key, value);
    for (const auto& [key, text] : m_spec.texts)
        showText(key, text);
}

void ToolForm::showNumber(const std::string& key, double value) {
    if (auto* box = findChild<NumberBox*>(nameOf(key)))
        box->showValue(value);
}

void ToolForm::showText(const std::string& key, const std::string& text) {
    auto* box = findChild<QLineEdit*>(nameOf(key));
    if (box != nullptr)
        proveout::showText(*box, QString::fromStdString(text));
}

void ToolForm::chooseShape(int index) {
    ToolSpec chosen = readSpec(cutterShapes()[static_cast<std::size_t>(index)].key);
    const std::vector<ShapeKey> before = keysOf(m_spec.shape);
    for (const ShapeKey& key : keysOf(chosen.shape)) {
        // What both shapes have (diameter, lengths, holder) is kept, but not a default that was left as it
        // is.
        const ShapeKey* same = sameKey(before, key);
        if (same == nullptr ||
            (!key.isText() && !key.required && m_spec.values[key.key] == same->defaultValue))
            continue;
        if (key.isText())
            chosen.texts[key.key] = m_spec.texts[key.key];
        else
            chosen.values[key.key] = std::clamp(m_spec.values[key.key], key.minimum, key.maximum);
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
    QWidget* box = key.isText() ? textBox(key) : numberBox(key);
    box->setObjectName(nameOf(key.key));
    box->setMinimumWidth(kBoxWidth);
    box->setAccessibleName(coreText(key.label));
    m_layout->addRow(coreText(key.label), box);
}

QWidget* ToolForm::numberBox(const ShapeKey& key) {
    auto* box = new NumberBox(this);
    box->setDecimals(key.whole ? 0 : 3);
    box->setRange(key.minimum, key.maximum);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setSuffix(u' ' + coreText(key.unit));
    box->setValue(m_spec.values[key.key]);
    const QString unit = coreText(key.unit);
    box->setToolTip(tr("%1\nRange: %2 to %3 %4\nDefault: %5 %4")
                        .arg(coreText(key.label), locale().toString(key.minimum),
                             locale().toString(key.maximum), unit, locale().toString(key.defaultValue)));
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, name = std::string(key.key)](double value) {
        m_spec.values[name] = value;
        emit edited();
    });
    return box;
}

QString ToolForm::textHint(const ShapeKey& key) {
    if (!key.required)
        return tr("Example: %1").arg(QLatin1String(key.exampleText()));
    return tr("For an arc, add the centre or the radius to its end point, as in %1 or %2; a negative radius "
              "is "
              "concave.\nDefault: %3")
        .arg(QStringLiteral("4/1@3/1"), QStringLiteral("4/1@1"), QLatin1String(key.defaultText));
}

QWidget* ToolForm::textBox(const ShapeKey& key) {
    auto* box = new QLineEdit(QString::fromStdString(m_spec.texts[key.key]), this);
    box->setToolTip(coreText(key.label) + u'\n' + textHint(key));
    connect(box, &QLineEdit::editingFinished, this, [this, box, name = std::string(key.key)] {
        box->setModified(false);
        if (box->text().toStdString() == m_spec.texts[name])
            return;
        m_spec.texts[name] = box->text().toStdString();
        emit edited();
    });
    return box;
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
