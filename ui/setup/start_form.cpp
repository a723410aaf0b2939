// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/setup/start_form.h"

#include <algorithm>
#include <cstddef>

#include <QCheckBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "core/simulation/setup/setup_fields.h"
#include "core/simulation/setup/tool_choice.h"
#include "ui/look/choice_box.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/field_text.h"
#include "ui/look/number_box.h"

namespace proveout {

namespace {

constexpr int kBoxWidth = 110;

QString nameOf(int tool) {
    return QStringLiteral("T%1").arg(tool);
}

} // namespace

StartForm::StartForm(QWidget* parent)
    : QWidget(parent), m_toolLabel(new QLabel(this)), m_tool(new ChoiceBox(this)),
      m_known(new QCheckBox(this)) {
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setColumnStretch(1, 1);
    m_tool->setObjectName(QStringLiteral("start-tool"));
    m_toolLabel->setBuddy(m_tool);
    layout->addWidget(m_toolLabel, 0, 0);
    layout->addWidget(m_tool, 0, 1);
    m_known->setObjectName(QStringLiteral("start-known"));
    layout->addWidget(m_known, 1, 0, 1, 2);
    for (std::size_t axis = 0; axis < m_position.size(); ++axis) {
        auto* label = new QLabel(this);
        auto* box = new NumberBox(this);
        box->setObjectName(QStringLiteral("start-") + QLatin1Char("xyz"[axis]));
        setUpBox(*box, setup_field::kStart);
        box->setMinimumWidth(kBoxWidth); // its default would fit the largest number of the range
        label->setBuddy(box);
        const auto row = static_cast<int>(axis) + 2;
        layout->addWidget(label, row, 0);
        layout->addWidget(box, row, 1);
        m_axisLabels[axis] = label;
        m_position[axis] = box;
        connect(box, &QDoubleSpinBox::valueChanged, this, &StartForm::edited);
    }
    connect(m_tool, &QComboBox::activated, this, &StartForm::edited);
    connect(m_known, &QCheckBox::toggled, this, [this] {
        showPosition();
        emit edited();
    });
    retranslate();
    showPosition();
}

void StartForm::show(const Setup& setup, const Program* program) {
    m_setup = setup;
    m_assumed = program == nullptr ? std::nullopt : assumedTool(*program, setup);
    fillTools();
    const QSignalBlocker quiet(m_known);
    m_known->setChecked(setup.start.has_value());
    const Vec3 start = setup.start.value_or(Vec3(0));
    for (std::size_t axis = 0; axis < m_position.size(); ++axis)
        m_position[axis]->showValue(start[static_cast<int>(axis)]);
    showPosition();
}

void StartForm::put(Setup& setup) const {
    const QVariant tool = m_tool->currentData();
    setup.startTool = tool.isValid() ? std::optional(tool.toInt()) : std::nullopt;
    if (!m_known->isChecked()) {
        setup.start.reset();
        return;
    }
    Vec3 start = setup.start.value_or(Vec3(0));
    for (std::size_t axis = 0; axis < m_position.size(); ++axis)
        readShown(start[static_cast<int>(axis)], *m_position[axis]);
    setup.start = start;
}

/// Not set, the empty spindle and the tools of the table; also the set tool if it is not one of these.
std::vector<StartForm::Item> StartForm::toolItems() const {
    std::vector<Item> items{
        {m_assumed ? tr("Not set: %1 is assumed").arg(nameOf(*m_assumed)) : tr("Not set"), {}}};
    if (m_setup.tools.find(0) == nullptr)
        items.emplace_back(tr("Empty spindle"), 0);
    for (const auto& row : m_setup.tools.tools())
        items.emplace_back(nameOf(row.first), row.first);
    const auto isSet = [this](const Item& item) { return item.second == QVariant(*m_setup.startTool); };
    if (m_setup.startTool && std::ranges::none_of(items, isSet))
        items.emplace_back(tr("%1, not in the tool table").arg(nameOf(*m_setup.startTool)),
                           *m_setup.startTool);
    return items;
}

/// Updates the items in place, because the list may be open.
void StartForm::fillTools() {
    const QSignalBlocker quiet(m_tool);
    const std::vector<Item> items = toolItems();
    const auto count = static_cast<int>(items.size());
    while (m_tool->count() > count)
        m_tool->removeItem(m_tool->count() - 1);
    while (m_tool->count() < count)
        m_tool->addItem(QString());
    for (int i = 0; i < count; ++i) {
        m_tool->setItemText(i, items[static_cast<std::size_t>(i)].first);
        m_tool->setItemData(i, items[static_cast<std::size_t>(i)].second);
    }
    m_tool->setCurrentIndex(m_setup.startTool ? m_tool->findData(*m_setup.startTool) : 0);
}

void StartForm::showPosition() {
    for (std::size_t axis = 0; axis < m_position.size(); ++axis) {
        m_axisLabels[axis]->setVisible(m_known->isChecked());
        m_position[axis]->setVisible(m_known->isChecked());
    }
}

void StartForm::retranslate() {
    m_toolLabel->setText(coreText(setup_field::kStartTool.label));
    showFieldTexts(*m_tool, setup_field::kStartTool);
    m_known->setText(tr("Start position is known"));
    m_known->setToolTip(coreText(setup_field::kStart.help));
    for (std::size_t axis = 0; axis < m_position.size(); ++axis) {
        const QString name = tr("Start %1", "an axis").arg(QLatin1Char("XYZ"[axis]));
        m_axisLabels[axis]->setText(name);
        showFieldTexts(*m_position[axis], setup_field::kStart, fieldNumber(setup_field::kStart, 0, locale()));
        m_position[axis]->setAccessibleName(name); // named after its axis
    }
    fillTools();
}

void StartForm::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace proveout
