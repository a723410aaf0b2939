// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/findings/rules_dialog.h"

#include <set>
#include <string>
#include <utility>

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/simulation/run/cutting_findings.h"
#include "core/verification/findings/findings.h"
#include "core/verification/findings/rule_findings.h"
#include "ui/findings/tool_limits_editor.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/field_text.h"
#include "ui/look/number_box.h"
#include "ui/look/panel_layout.h"

namespace proveout {

namespace {

constexpr int kIdRole = Qt::UserRole;
constexpr int kListWidth = 300; ///< px
constexpr int kHeight = 460;
constexpr int kBoxWidth = 124;

} // namespace

RulesDialog::RulesDialog(CheckRules rules, QWidget* parent)
    : QDialog(parent), m_rules(std::move(rules)), m_list(new QListWidget(this)),
      m_ofTools(new ToolLimitsEditor(this)) {
    setWindowTitle(tr("Rules of the Check"));
    m_list->setObjectName(QStringLiteral("rules"));
    m_list->setMinimumWidth(kListWidth);
    m_list->setMinimumHeight(kHeight);
    auto* limits = new QFormLayout;
    RuleLimits defaults;
    describe(defaults, [&](double& value, const Field& field) {
        auto* box = new NumberBox(this);
        box->setObjectName(QLatin1String(field.key));
        setUpBox(*box, field);
        box->setMinimumWidth(kBoxWidth);
        showFieldTexts(*box, field, fieldNumber(field, value, locale()));
        limits->addRow(coreText(field.label), box);
        m_boxes.push_back(box);
    });
    auto* where = wrappedLabel(this);
    where->setText(tr(
        "The job file keeps these settings. How deep, wide and fast a tool may cut is in the tool table; the "
        "limits of the machine are in its values."));
    auto* right = new QVBoxLayout;
    right->addLayout(limits);
    right->addWidget(new QLabel(tr("Other limits for single tools"), this));
    right->addWidget(m_ofTools, 1);
    right->addWidget(where);
    auto* columns = new QHBoxLayout;
    columns->addWidget(m_list, 1);
    columns->addLayout(right);
    auto* buttons = new QDialogButtonBox(
        QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::RestoreDefaults, this);
    connect(buttons, &QDialogButtonBox::accepted, this, &RulesDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &RulesDialog::reject);
    connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this,
            &RulesDialog::restore);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(columns);
    layout->addWidget(buttons);
    show(m_rules);
}

void RulesDialog::restore() {
    m_rules.limits = {};
    m_rules.limitsOfTools.clear();
    m_rules.off.clear();
    show(m_rules);
}

/// Rules of one tool that are off have rows of their own, after their rule.
void RulesDialog::show(const CheckRules& rules) {
    m_list->clear();
    std::set<std::string> shown;
    const auto addRule = [&](const FindingRow* row) {
        if (!shown.insert(row->id).second)
            return;
        addRow(coreText(row->title), row->id, !rules.off.contains(row->id));
        for (const auto& [id, reason] : rules.off)
            if (id != row->id && ruleOf(id) == row->id)
                addRow(QStringLiteral("%1 (%2)").arg(
                           coreText(row->title),
                           QString::fromStdString(id.substr(std::string(row->id).size() + 1))),
                       id, false);
    };
    for (const FindingRow* row : cutting_finding::kCuttingRows)
        if (row->severity == Severity::fault) // the others say what was not judged
            addRule(row);
    for (const FindingRow* row : rule_finding::kRuleRows)
        addRule(row);
    RuleLimits limits = rules.limits;
    m_ofTools->showLimits(rules.limitsOfTools);
    std::size_t row = 0;
    describe(limits, [&](double& value, const Field&) { m_boxes[row++]->showValue(value); });
}

void RulesDialog::addRow(const QString& title, const std::string& id, bool on) {
    auto* item = new QListWidgetItem(title, m_list);
    item->setData(kIdRole, QString::fromStdString(id));
    item->setToolTip(QString::fromStdString(id));
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(on ? Qt::Checked : Qt::Unchecked);
}

CheckRules RulesDialog::rules() const {
    CheckRules rules = m_rules;
    for (int row = 0; row < m_list->count(); ++row) {
        const std::string id = m_list->item(row)->data(kIdRole).toString().toStdString();
        if (m_list->item(row)->checkState() == Qt::Checked)
            rules.off.erase(id);
        else
            rules.off.insert({id, {}}); // a reason stays
    }
    rules.limitsOfTools = m_ofTools->limits();
    std::size_t row = 0;
    describe(rules.limits, [&](double& value, const Field&) { readShown(value, *m_boxes[row++]); });
    return rules;
}

} // namespace proveout
