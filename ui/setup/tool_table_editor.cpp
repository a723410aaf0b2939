// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/setup/tool_table_editor.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "core/base/tool_number.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/icons.h"
#include "ui/look/number_box.h"
#include "ui/look/panel_layout.h"
#include "ui/readout/tool_actions.h"
#include "ui/setup/edited_origin.h"
#include "ui/setup/tool_drawing.h"
#include "ui/setup/tool_form.h"

namespace proveout {

namespace {

constexpr int kRowsShown = 5;

/// The labels of the given keys of a cutter, such as those in ToolOrigin::defaults.
QString labelsOf(const Cutter& cutter, const std::vector<std::string>& keys) {
    QStringList names;
    for (const std::string& key : keys) {
        if (key == "shape")
            names << ToolTableEditor::tr("Shape");
        for (const ShapeKey& row : keysOf(readSpec(cutter.spec()).shape))
            if (key == row.key)
                names << coreText(row.label);
    }
    return names.join(QStringLiteral(", "));
}

} // namespace

ToolTableEditor::ToolTableEditor(QWidget* parent)
    : QWidget(parent), m_list(new QTreeWidget(this)), m_add(new QPushButton(this)),
      m_remove(new QPushButton(this)), m_confirm(new QPushButton(this)), m_confirmAll(new QPushButton(this)),
      m_numberLabel(new QLabel(this)), m_number(new CountBox(this)), m_details(new QWidget(this)),
      m_form(new ToolForm(m_details)), m_drawing(new ToolDrawing(m_details)),
      m_origin(wrappedLabel(m_details)), m_problem(new QLabel(this)) {
    m_list->setRootIsDecorated(false);
    m_list->setColumnCount(3);
    m_list->header()->setStretchLastSection(false);
    m_list->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_list->header()->setSectionResizeMode(1, QHeaderView::Stretch);
    m_confirm->setObjectName(QStringLiteral("tool-confirm"));
    m_confirmAll->setObjectName(QStringLiteral("tool-confirm-all"));
    m_origin->setObjectName(QStringLiteral("tool-origin"));
    m_origin->setTextFormat(Qt::RichText);
    m_list->setFixedHeight(m_list->header()->sizeHint().height() + kRowsShown * (fontMetrics().height() + 6));
    m_number->setRange(kLeastTool, kLargestTool);
    m_number->setPrefix(QStringLiteral("T"));
    m_numberLabel->setBuddy(m_number);
    m_problem->setWordWrap(true);
    m_problem->hide();

    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_add);
    buttons->addWidget(m_remove);
    buttons->addStretch(1);
    auto* confirming = new QHBoxLayout;
    confirming->addWidget(m_confirm);
    confirming->addWidget(m_confirmAll);
    confirming->addStretch(1);
    auto* number = new QHBoxLayout;
    number->addWidget(m_numberLabel);
    number->addWidget(m_number, 1);
    auto* details = new QVBoxLayout(m_details);
    details->setContentsMargins(0, 0, 0, 0);
    details->addWidget(m_origin);
    details->addLayout(number);
    details->addWidget(m_drawing);
    details->addWidget(m_form);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_list);
    layout->addLayout(buttons);
    layout->addLayout(confirming);
    layout->addWidget(m_details);
    layout->addWidget(m_problem);

    connect(m_list, &QTreeWidget::currentItemChanged, this, &ToolTableEditor::select);
    connect(m_add, &QPushButton::clicked, this, [this] {
        add(freeNumber());
        emit edited();
    });
    connect(m_remove, &QPushButton::clicked, this, &ToolTableEditor::removeSelected);
    connect(m_confirm, &QPushButton::clicked, this, &ToolTableEditor::confirmSelected);
    connect(m_confirmAll, &QPushButton::clicked, this, &ToolTableEditor::confirmAll);
    connect(m_origin, &QLabel::linkActivated, this,
            [this](const QString& line) { emit lineWanted(line.toUInt()); });
    connect(m_number, &QSpinBox::valueChanged, this, &ToolTableEditor::renumber);
    connect(m_form, &ToolForm::edited, this, &ToolTableEditor::applyForm);
    retranslate();
    fillList(-1);
}

void ToolTableEditor::show(const ToolTable& tools) {
    if (tools == m_tools)
        return;
    m_tools = tools;
    fillList(selectedNumber());
}

void ToolTableEditor::add(int number) {
    Result<Cutter> cutter = parseCutter(writeSpec(defaultSpec()));
    if (!cutter || m_tools.find(number) != nullptr)
        return;
    m_tools.set(number, std::move(*cutter), {ToolSource::assumed});
    fillList(number);
}

void ToolTableEditor::edit(int number) {
    if (m_tools.find(number) == nullptr) {
        add(number);
        emit edited();
    } else {
        fillList(number);
    }
    if (auto* size = m_form->findChild<QAbstractSpinBox*>()) {
        size->setFocus();
        size->selectAll();
    }
}

int ToolTableEditor::selectedNumber() const {
    const QTreeWidgetItem* item = m_list->currentItem();
    return item == nullptr ? -1 : item->data(0, Qt::UserRole).toInt();
}

int ToolTableEditor::freeNumber() const {
    int number = 1;
    while (m_tools.find(number) != nullptr)
        ++number;
    return number;
}

void ToolTableEditor::fillList(int selected) {
    {
        const QSignalBlocker quiet(m_list);
        m_list->clear();
        for (const auto& [number, cutter] : m_tools.tools()) {
            auto* item = new QTreeWidgetItem(m_list, {QStringLiteral("T%1").arg(number)});
            item->setData(0, Qt::UserRole, number);
            showTool(*item, number);
            if (number == selected)
                m_list->setCurrentItem(item);
        }
        if (m_list->currentItem() == nullptr && m_list->topLevelItemCount() > 0)
            m_list->setCurrentItem(m_list->topLevelItem(0));
    }
    select();
}

void ToolTableEditor::showTool(QTreeWidgetItem& item, int number) const {
    const Cutter& cutter = *m_tools.find(number);
    const ToolOrigin* origin = m_tools.unconfirmedOrigin(number);
    item.setText(1, cutterText(cutter, locale()));
    item.setToolTip(1, QString::fromStdString(cutter.spec()));
    QFont font = m_list->font();
    font.setItalic(origin != nullptr);
    for (int column = 0; column < m_list->columnCount(); ++column)
        item.setFont(column, font);
    item.setIcon(2, origin == nullptr ? QIcon() : icon(QStringLiteral("warning")));
    if (origin == nullptr) {
        item.setText(2, tr("Defined"));
        item.setToolTip(2, QString());
    } else if (origin->source == ToolSource::comment) {
        item.setText(2, tr("Comment, line %1").arg(origin->line));
        item.setToolTip(2, QString::fromStdString(origin->comment).toHtmlEscaped());
    } else {
        item.setText(2, tr("Assumed"));
        item.setToolTip(2, tr("Default sizes; enter those of your cutter, or confirm them"));
    }
}

/// Shows where the sizes of the selected tool come from while they are unconfirmed.
void ToolTableEditor::showOrigin() {
    const int number = selectedNumber();
    const ToolOrigin* origin = m_tools.unconfirmedOrigin(number);
    m_confirm->setVisible(origin != nullptr);
    m_confirmAll->setVisible(m_tools.unconfirmed().size() > 1);
    m_origin->setVisible(origin != nullptr);
    if (origin == nullptr)
        return;
    m_origin->setText(originText(*m_tools.find(number), *origin));
}

QString ToolTableEditor::originText(const Cutter& cutter, const ToolOrigin& origin) {
    const QString line = QStringLiteral("<br>");
    QString text =
        origin.source == ToolSource::assumed
            ? tr("These sizes are assumed. Enter those of your cutter, or confirm them.")
            : tr("From the comment in <a href=\"%1\">line %1</a>: <i>%2</i>")
                  .arg(QString::number(origin.line), QString::fromStdString(origin.comment).toHtmlEscaped());
    if (const QString defaults = labelsOf(cutter, origin.defaults); !defaults.isEmpty())
        text += line + tr("Not in the comment, defaults used: %1").arg(defaults.toHtmlEscaped());
    if (const QString entered = labelsOf(cutter, origin.entered); !entered.isEmpty())
        text += line + tr("Entered: %1").arg(entered.toHtmlEscaped());
    return text;
}

void ToolTableEditor::confirmSelected() {
    m_tools.confirm(selectedNumber());
    fillList(selectedNumber());
    emit edited();
}

void ToolTableEditor::confirmAll() {
    m_tools.confirmAll();
    fillList(selectedNumber());
    emit edited();
}

void ToolTableEditor::select() {
    const Cutter* cutter = m_tools.find(selectedNumber());
    showOrigin();
    m_details->setVisible(cutter != nullptr);
    m_remove->setEnabled(cutter != nullptr);
    m_problem->hide();
    if (cutter == nullptr)
        return;
    m_number->showValue(selectedNumber());
    m_drawing->show(*cutter);
    m_form->show(readSpec(cutter->spec()));
}

void ToolTableEditor::applyForm() {
    const int number = selectedNumber();
    Result<Cutter> cutter = parseCutter(writeSpec(m_form->spec()));
    m_problem->setVisible(!cutter);
    if (!cutter) {
        m_problem->setText(sentence(cutter.error().front()));
        return;
    }
    const ToolOrigin* origin = m_tools.unconfirmedOrigin(number);
    std::optional<ToolOrigin> unconfirmed;
    if (origin != nullptr)
        unconfirmed = editedOrigin(*origin, readSpec(m_tools.find(number)->spec()), m_form->spec());
    m_drawing->show(*cutter);
    m_tools.set(number, std::move(*cutter), unconfirmed.value_or(ToolOrigin()));
    showTool(*m_list->currentItem(), number);
    showOrigin();
    emit edited();
}

void ToolTableEditor::renumber(int number) {
    const int before = selectedNumber();
    if (number == before)
        return;
    m_problem->setVisible(m_tools.find(number) != nullptr);
    if (m_tools.find(number) != nullptr) {
        m_problem->setText(tr("T%1 is already in the table.").arg(number));
        return;
    }
    Cutter cutter = *m_tools.find(before);
    const ToolOrigin* unconfirmed = m_tools.unconfirmedOrigin(before);
    ToolOrigin origin = unconfirmed == nullptr ? ToolOrigin() : *unconfirmed;
    m_tools.remove(before);
    m_tools.set(number, std::move(cutter), std::move(origin));
    fillList(number);
    emit edited();
}

void ToolTableEditor::removeSelected() {
    m_tools.remove(selectedNumber());
    fillList(-1);
    emit edited();
}

void ToolTableEditor::retranslate() {
    m_list->setHeaderLabels({tr("Tool"), tr("Cutter"), tr("Source")});
    m_confirm->setText(tr("Confirm"));
    m_confirm->setToolTip(tr("Confirm the sizes of the selected tool"));
    m_confirmAll->setText(tr("Confirm All"));
    m_confirmAll->setToolTip(tr("Confirm the sizes of all tools"));
    m_list->setAccessibleName(tr("Tools"));
    m_add->setText(tr("Add"));
    m_add->setToolTip(tr("Add a tool with the next free number"));
    m_remove->setText(tr("Remove"));
    m_remove->setToolTip(tr("Remove the selected tool"));
    m_numberLabel->setText(tr("Number"));
    m_number->setToolTip(
        tr("The T word that calls this tool (no unit)\nRange: %1 to %2\nDefault: the next free number")
            .arg(kLeastTool)
            .arg(kLargestTool));
    m_number->setAccessibleName(tr("Tool number"));
}

void ToolTableEditor::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        fillList(selectedNumber());
    }
}

} // namespace proveout
