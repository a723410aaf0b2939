// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/setup/tool_table_editor.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "core/base/tool_number.h"
#include "ui/diagnostic_text.h"
#include "ui/number_box.h"
#include "ui/setup/tool_form.h"

namespace proveout {

namespace {

constexpr int kRowsShown = 5;

QString description(const Cutter& cutter, const QLocale& locale) {
    const ToolSpec spec = readSpec(cutter.spec());
    return QStringLiteral("%1  ⌀ %2 mm")
        .arg(coreText(shapeRow(spec.shape).label), locale.toString(2 * cutter.radius(), 'g', 6));
}

} // namespace

ToolTableEditor::ToolTableEditor(QWidget* parent)
    : QWidget(parent), m_list(new QTreeWidget(this)), m_add(new QPushButton(this)),
      m_remove(new QPushButton(this)), m_numberLabel(new QLabel(this)), m_number(new CountBox(this)),
      m_details(new QWidget(this)), m_form(new ToolForm(m_details)), m_problem(new QLabel(this)) {
    m_list->setRootIsDecorated(false);
    m_list->setColumnCount(2);
    m_list->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
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
    auto* number = new QHBoxLayout;
    number->addWidget(m_numberLabel);
    number->addWidget(m_number, 1);
    auto* details = new QVBoxLayout(m_details);
    details->setContentsMargins(0, 0, 0, 0);
    details->addLayout(number);
    details->addWidget(m_form);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_list);
    layout->addLayout(buttons);
    layout->addWidget(m_details);
    layout->addWidget(m_problem);

    connect(m_list, &QTreeWidget::currentItemChanged, this, &ToolTableEditor::select);
    connect(m_add, &QPushButton::clicked, this, [this] {
        add(freeNumber());
        emit edited();
    });
    connect(m_remove, &QPushButton::clicked, this, &ToolTableEditor::removeSelected);
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
    Result<Cutter> cutter = parseCutter(writeSpec(standardSpec()));
    if (!cutter || m_tools.find(number) != nullptr)
        return;
    m_tools.set(number, std::move(*cutter));
    fillList(number);
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
            auto* item = new QTreeWidgetItem(
                m_list, {QStringLiteral("T%1").arg(number), description(cutter, locale())});
            item->setData(0, Qt::UserRole, number);
            item->setToolTip(1, QString::fromStdString(cutter.spec()));
            if (number == selected)
                m_list->setCurrentItem(item);
        }
        if (m_list->currentItem() == nullptr && m_list->topLevelItemCount() > 0)
            m_list->setCurrentItem(m_list->topLevelItem(0));
    }
    select();
}

void ToolTableEditor::select() {
    const Cutter* cutter = m_tools.find(selectedNumber());
    m_details->setVisible(cutter != nullptr);
    m_remove->setEnabled(cutter != nullptr);
    m_problem->hide();
    if (cutter == nullptr)
        return;
    const QSignalBlocker quiet(m_number);
    m_number->setValue(selectedNumber());
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
    m_list->currentItem()->setText(1, description(*cutter, locale()));
    m_tools.set(number, std::move(*cutter));
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
    m_tools.remove(before);
    m_tools.set(number, std::move(cutter));
    fillList(number);
    emit edited();
}

void ToolTableEditor::removeSelected() {
    m_tools.remove(selectedNumber());
    fillList(-1);
    emit edited();
}

void ToolTableEditor::retranslate() {
    m_list->setHeaderLabels({tr("Tool"), tr("Cutter")});
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
