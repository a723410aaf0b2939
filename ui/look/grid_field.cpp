// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/grid_field.h"

#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QSignalBlocker>

#include "core/simulation/setup/setup_fields.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/field_text.h"
#include "ui/look/number_box.h"

namespace proveout {

namespace {

constexpr int kBoxWidth = 93;

} // namespace

GridField::GridField(const QString& name, QWidget* parent)
    : QWidget(parent), m_spacing(new NumberBox(this)), m_automatic(new QCheckBox(this)) {
    m_spacing->setObjectName(name);
    m_automatic->setObjectName(name + QStringLiteral("-automatic"));
    setUpBox(*m_spacing, setup_field::kGrid);
    m_spacing->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    m_spacing->setMinimumWidth(kBoxWidth);
    setFocusProxy(m_spacing);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_spacing, 1);
    layout->addWidget(m_automatic);
    connect(m_spacing, &QDoubleSpinBox::valueChanged, this, [this] {
        const QSignalBlocker quiet(m_automatic);
        m_automatic->setChecked(false);
        emit edited();
    });
    connect(m_automatic, &QCheckBox::toggled, this, &GridField::edited);
    retranslate();
}

void GridField::show(const Setup& setup) {
    m_spacing->showValue(setup.spacing);
    const QSignalBlocker quiet(m_automatic);
    m_automatic->setChecked(setup.automaticGrid);
}

void GridField::put(Setup& setup) const {
    setup.automaticGrid = m_automatic->isChecked();
    if (!setup.automaticGrid)
        readShown(setup.spacing, *m_spacing);
}

void GridField::retranslate() {
    showFieldTexts(*m_spacing, setup_field::kGrid, tr("automatic"));
    m_automatic->setText(tr("Automatic"));
    m_automatic->setAccessibleName(tr("Automatic grid spacing"));
    m_automatic->setToolTip(coreText(setup_field::kGrid.automatic));
}

void GridField::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace proveout
