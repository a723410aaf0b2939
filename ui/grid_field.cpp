// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/grid_field.h"

#include <cmath>

#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QSignalBlocker>

#include "core/simulation/setup/setup_fields.h"
#include "ui/diagnostic_text.h"
#include "ui/number_box.h"

namespace proveout {

namespace {

constexpr int kDecimals = 4; ///< an automatic spacing has two digits, and may be a few micrometres
constexpr int kBoxWidth = 93;
constexpr double kShown = 0.00005; ///< what the box cannot show exactly stays until it is edited

} // namespace

GridField::GridField(const QString& name, QWidget* parent)
    : QWidget(parent), m_spacing(new NumberBox(this)), m_automatic(new QCheckBox(this)) {
    m_spacing->setObjectName(name);
    m_automatic->setObjectName(name + QStringLiteral("-automatic"));
    m_spacing->setDecimals(kDecimals);
    m_spacing->setRange(setup_field::kGrid.minimum, setup_field::kGrid.maximum);
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
    if (!setup.automaticGrid && std::abs(setup.spacing - m_spacing->value()) > kShown)
        setup.spacing = m_spacing->value();
}

void GridField::retranslate() {
    const Field& field = setup_field::kGrid;
    const QString name = coreText(field.label);
    m_spacing->setSuffix(tr(" mm"));
    m_spacing->setAccessibleName(name);
    m_spacing->setToolTip(
        tr("%1\nRange: %2 to %3 mm\nDefault: automatic")
            .arg(coreText(field.help), locale().toString(field.minimum), locale().toString(field.maximum)));
    m_automatic->setText(tr("Automatic"));
    m_automatic->setAccessibleName(tr("Automatic grid spacing"));
    m_automatic->setToolTip(tr("One tenth of the smallest cutter diameter, with 1 to 4 million points"));
}

void GridField::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace proveout
