// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/findings/tool_limits_editor.h"

#include <algorithm>
#include <string_view>

#include <QComboBox>
#include <QHeaderView>
#include <QPushButton>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/base/tool_number.h"
#include "core/simulation/setup/check_rules.h"
#include "core/verification/rules/rules.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/field_text.h"
#include "ui/look/number_box.h"

namespace proveout {

namespace {

enum Column { kTool, kRule, kValue, kRemove, kColumns };

constexpr int kRowsShown = 4;
constexpr int kTableWidth = 430; ///< px
constexpr int kToolWidth = 72;
constexpr int kValueWidth = 110;
constexpr const char* kExact = "exact"; ///< the limit that a box shows rounded

/// The rule that a box shows.
const Rule& chosen(const QComboBox& box) {
    const std::string id = box.currentData().toString().toStdString();
    return *std::ranges::find_if(rules(), [&](const Rule& rule) { return id == rule.id(); });
}

double usualLimit(std::string_view key) {
    double usual = 0;
    RuleLimits limits;
    describe(limits, [&](double value, const Field& field) {
        if (key == field.key)
            usual = value;
    });
    return usual;
}

void showLimit(NumberBox& box, const QComboBox& rule, double value) {
    const Field field = *limitField(chosen(rule).limit);
    setUpBox(box, field);
    showFieldTexts(box, field);
    box.setProperty(kExact, value);
    box.showValue(value);
}

} // namespace

ToolLimitsEditor::ToolLimitsEditor(QWidget* parent)
    : QWidget(parent), m_table(new QTableWidget(0, kColumns, this)) {
    m_table->setObjectName(QStringLiteral("tool-limits"));
    m_table->setHorizontalHeaderLabels({tr("Tool"), tr("Rule"), tr("Limit"), QString()});
    m_table->verticalHeader()->hide();
    m_table->setSelectionMode(QAbstractItemView::NoSelection);
    m_table->horizontalHeader()->setSectionResizeMode(kRule, QHeaderView::Stretch);
    m_table->setColumnWidth(kTool, kToolWidth);
    m_table->setColumnWidth(kValue, kValueWidth);
    m_table->horizontalHeader()->setSectionResizeMode(kRemove, QHeaderView::ResizeToContents);
    auto* another = new QPushButton(tr("Add"), this);
    another->setObjectName(QStringLiteral("tool-limit-add"));
    connect(another, &QPushButton::clicked, this, &ToolLimitsEditor::addAnother);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(m_table);
    layout->addWidget(another, 0, Qt::AlignLeft);
    m_table->setMinimumWidth(kTableWidth);
    const int row = m_table->verticalHeader()->defaultSectionSize();
    m_table->setMinimumHeight(m_table->horizontalHeader()->sizeHint().height() + kRowsShown * row);
}

void ToolLimitsEditor::showLimits(const std::map<std::string, double>& limits) {
    m_table->setRowCount(0);
    m_others.clear();
    for (const auto& [name, value] : limits) {
        const auto limit = parseLimitOfTool(name);
        if (limit && isJudgedBy(*limit))
            add(limit->tool, limit->rule, value);
        else
            m_others.emplace(name, value);
    }
}

void ToolLimitsEditor::add(int tool, const std::string& rule, double value) {
    const int row = m_table->rowCount();
    m_table->insertRow(row);
    auto* toolBox = new CountBox(m_table);
    toolBox->setPrefix(QStringLiteral("T"));
    toolBox->setRange(kLeastTool, kLargestTool);
    toolBox->showValue(tool);
    auto* ruleBox = new QComboBox(m_table);
    for (const Rule& one : rules())
        if (one.limit != nullptr)
            ruleBox->addItem(coreText(one.rows.front()->title), QString::fromLatin1(one.id()));
    ruleBox->setCurrentIndex(ruleBox->findData(QString::fromStdString(rule)));
    auto* valueBox = new NumberBox(m_table);
    showLimit(*valueBox, *ruleBox, value);
    connect(ruleBox, &QComboBox::currentIndexChanged, valueBox,
            [ruleBox, valueBox] { showLimit(*valueBox, *ruleBox, usualLimit(chosen(*ruleBox).limit)); });
    auto* remove = new QToolButton(m_table);
    remove->setAutoRaise(true);
    remove->setText(QStringLiteral("✕"));
    remove->setToolTip(tr("Remove this limit"));
    connect(remove, &QToolButton::clicked, this, [this, remove] { this->remove(*remove); });
    m_table->setCellWidget(row, kTool, toolBox);
    m_table->setCellWidget(row, kRule, ruleBox);
    m_table->setCellWidget(row, kValue, valueBox);
    m_table->setCellWidget(row, kRemove, remove);
}

void ToolLimitsEditor::addAnother() {
    const auto first = std::ranges::find_if(rules(), [](const Rule& rule) { return rule.limit != nullptr; });
    add(1, first->id(), usualLimit(first->limit));
    m_table->scrollToBottom();
    m_table->cellWidget(m_table->rowCount() - 1, kTool)->setFocus();
}

void ToolLimitsEditor::remove(const QWidget& cell) {
    for (int row = 0; row < m_table->rowCount(); ++row)
        if (m_table->cellWidget(row, kRemove) == &cell)
            return m_table->removeRow(row);
}

std::map<std::string, double> ToolLimitsEditor::limits() const {
    std::map<std::string, double> limits = m_others;
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const auto* tool = qobject_cast<CountBox*>(m_table->cellWidget(row, kTool));
        const auto* rule = qobject_cast<QComboBox*>(m_table->cellWidget(row, kRule));
        const auto* value = qobject_cast<NumberBox*>(m_table->cellWidget(row, kValue));
        double limit = value->property(kExact).toDouble();
        readShown(limit, *value);
        limits[ruleForTool(chosen(*rule).id(), tool->value()) + '.' + chosen(*rule).limit] = limit;
    }
    return limits;
}

} // namespace proveout
