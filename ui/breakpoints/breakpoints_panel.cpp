// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/breakpoints/breakpoints_panel.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStackedWidget>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/look/choice_box.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/number_box.h"
#include "ui/look/panel_layout.h"
#include "ui/look/theme.h"

namespace proveout {

namespace {

constexpr int kKindColumn = 0;
constexpr int kValueColumn = 1;
constexpr int kLastLine = 100'000'000;
constexpr double kFarthest = 1e6; // mm
constexpr int kMargin = 6;
constexpr int kNumberWidth = 160;

QString shownValue(const QLocale& locale, const Breakpoint& breakpoint) {
    switch (rowOf(breakpoint.kind).value) {
    case BreakpointValue::line:
        return QString::number(breakpoint.line);
    case BreakpointValue::height:
        return locale.toString(breakpoint.z, 'g', 9) + QStringLiteral(" mm");
    case BreakpointValue::condition:
        return QString::fromStdString(breakpoint.condition);
    case BreakpointValue::none:
        break;
    }
    return {};
}

} // namespace

BreakpointsPanel::BreakpointsPanel(Session& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_kind(new ChoiceBox(this)), m_value(new QStackedWidget(this)),
      m_line(new CountBox(this)), m_height(new NumberBox(this)), m_condition(new QLineEdit(this)),
      m_add(new QPushButton(this)), m_remove(new QPushButton(this)), m_problem(wrappedLabel(this)),
      m_list(new QTreeWidget(this)) {
    build();
    connect(m_kind, &QComboBox::currentIndexChanged, this, &BreakpointsPanel::showKind);
    connect(m_condition, &QLineEdit::returnPressed, this, &BreakpointsPanel::add);
    connect(m_condition, &QLineEdit::textEdited, m_problem, &QWidget::hide);
    connect(m_add, &QPushButton::clicked, this, &BreakpointsPanel::add);
    connect(m_remove, &QPushButton::clicked, this, &BreakpointsPanel::removeSelected);
    connect(m_list, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) { changed(*item); });
    connect(m_list, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem* item) { goTo(*item); });
    connect(m_list, &QTreeWidget::itemSelectionChanged, this,
            [this] { m_remove->setEnabled(!m_list->selectedItems().isEmpty()); });
    connect(new QShortcut(QKeySequence::Delete, m_list, nullptr, nullptr, Qt::WidgetShortcut),
            &QShortcut::activated, this, &BreakpointsPanel::removeSelected);
    connect(&session.breakpoints(), &BreakpointList::changed, this, &BreakpointsPanel::showBreakpoints);
    connect(&session.playback(), &PlaybackHub::stoppedAt, this, &BreakpointsPanel::showHit);
    retranslate();
    showBreakpoints();
}

void BreakpointsPanel::build() {
    auto* row = new QHBoxLayout;
    row->setContentsMargins(kMargin, kMargin, kMargin, 0);
    for (QWidget* widget : {static_cast<QWidget*>(m_kind), static_cast<QWidget*>(m_value),
                            static_cast<QWidget*>(m_add), static_cast<QWidget*>(m_remove)})
        row->addWidget(widget, widget == m_value ? 1 : 0);
    for (std::size_t kind = 0; kind < breakpointRows().size(); ++kind)
        m_kind->addItem(QString());
    m_value->addWidget(new QWidget(this)); // same order as BreakpointValue
    m_value->addWidget(m_line);
    m_value->addWidget(m_height);
    m_value->addWidget(m_condition);
    m_value->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_line->setRange(1, kLastLine);
    m_height->setRange(-kFarthest, kFarthest);
    m_line->setMaximumWidth(kNumberWidth);
    m_height->setMaximumWidth(kNumberWidth);
    m_height->setDecimals(3);
    m_height->setSuffix(QStringLiteral(" mm"));
    m_condition->setMaxLength(static_cast<int>(Condition::kLongest));
    m_problem->setContentsMargins(kMargin, 0, kMargin, 0);
    m_problem->setTextFormat(Qt::PlainText);
    m_problem->hide();
    colourProblem();
    m_remove->setEnabled(false);
    m_kind->setObjectName(QStringLiteral("breakpoint-kind"));
    m_condition->setObjectName(QStringLiteral("breakpoint-condition"));
    m_add->setObjectName(QStringLiteral("breakpoint-add"));
    m_remove->setObjectName(QStringLiteral("breakpoint-remove"));
    m_problem->setObjectName(QStringLiteral("breakpoint-problem"));
    m_list->setColumnCount(2);
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setAlternatingRowColors(true);
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->header()->setStretchLastSection(true);
    m_list->header()->setSectionResizeMode(kKindColumn, QHeaderView::ResizeToContents);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(row);
    layout->addWidget(m_problem);
    layout->addWidget(m_list, 1);
}

void BreakpointsPanel::colourProblem() {
    QPalette colours = palette();
    colours.setColor(QPalette::WindowText, meaningColors(colours).error);
    m_problem->setPalette(colours);
}

void BreakpointsPanel::showKind() {
    if (m_kind->currentIndex() < 0)
        return;
    const BreakpointRow& row = breakpointRows()[static_cast<std::size_t>(m_kind->currentIndex())];
    m_value->setCurrentIndex(static_cast<int>(row.value));
    m_kind->setToolTip(coreText(row.help));
    m_problem->hide();
}

/// Updates the rows in place, because a change may come from a row's own check box, which must not be deleted
/// then.
void BreakpointsPanel::showBreakpoints() {
    const QSignalBlocker quiet(m_list);
    const auto& all = m_session.breakpoints().all();
    const int count = static_cast<int>(all.size());
    if (count != m_list->topLevelItemCount())
        m_list->clearSelection(); // the rows have changed, so the old selection means nothing
    while (m_list->topLevelItemCount() > count)
        delete m_list->takeTopLevelItem(count);
    while (m_list->topLevelItemCount() < count) {
        auto* item = new QTreeWidgetItem(m_list);
        item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
    }
    for (int row = 0; row < count; ++row)
        showRow(*m_list->topLevelItem(row), all[static_cast<std::size_t>(row)]);
    m_remove->setEnabled(!m_list->selectedItems().isEmpty());
}

void BreakpointsPanel::showRow(QTreeWidgetItem& item, const Breakpoint& breakpoint) const {
    item.setCheckState(kKindColumn, breakpoint.enabled ? Qt::Checked : Qt::Unchecked);
    item.setText(kKindColumn, coreText(rowOf(breakpoint.kind).label));
    item.setText(kValueColumn, shownValue(locale(), breakpoint));
    item.setToolTip(kKindColumn, coreText(rowOf(breakpoint.kind).help));
}

/// Makes the breakpoint that stopped the run the current row.
void BreakpointsPanel::showHit(const BreakpointHit& hit) {
    const auto& all = m_session.breakpoints().all();
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i] == hit.breakpoint)
            m_list->setCurrentItem(m_list->topLevelItem(static_cast<int>(i)));
    }
}

void BreakpointsPanel::add() {
    const BreakpointRow& row = breakpointRows()[static_cast<std::size_t>(m_kind->currentIndex())];
    Breakpoint breakpoint;
    breakpoint.kind = row.kind;
    if (row.value == BreakpointValue::line)
        breakpoint.line = static_cast<std::uint32_t>(m_line->value());
    if (row.value == BreakpointValue::height)
        breakpoint.z = m_height->value();
    if (row.value == BreakpointValue::condition)
        breakpoint.condition = m_condition->text().trimmed().toStdString();
    const Result<Condition> condition = Condition::parse(breakpoint.condition);
    const bool wrong = row.value == BreakpointValue::condition && !condition;
    m_problem->setVisible(wrong);
    if (wrong) {
        m_problem->setText(sentence(condition.error().front()));
        m_condition->setFocus();
        return;
    }
    m_session.breakpoints().add(breakpoint);
}

void BreakpointsPanel::removeSelected() {
    std::vector<Breakpoint> kept;
    for (int i = 0; i < m_list->topLevelItemCount(); ++i) {
        if (!m_list->topLevelItem(i)->isSelected())
            kept.push_back(m_session.breakpoints().all()[static_cast<std::size_t>(i)]);
    }
    m_session.breakpoints().set(std::move(kept));
}

void BreakpointsPanel::changed(const QTreeWidgetItem& item) {
    std::vector<Breakpoint> all = m_session.breakpoints().all();
    const int index = m_list->indexOfTopLevelItem(const_cast<QTreeWidgetItem*>(&item));
    all[static_cast<std::size_t>(index)].enabled = item.checkState(kKindColumn) == Qt::Checked;
    m_session.breakpoints().set(std::move(all));
}

void BreakpointsPanel::goTo(const QTreeWidgetItem& item) {
    const int index = m_list->indexOfTopLevelItem(const_cast<QTreeWidgetItem*>(&item));
    const Breakpoint& breakpoint = m_session.breakpoints().all()[static_cast<std::size_t>(index)];
    if (breakpoint.kind == BreakpointKind::line)
        emit m_session.navigation().lineRequested(breakpoint.line, 1);
}

void BreakpointsPanel::retranslate() {
    for (int row = 0; row < m_kind->count(); ++row)
        m_kind->setItemText(row, coreText(breakpointRows()[static_cast<std::size_t>(row)].label));
    QString letters = tr("Compare with < <= > >= == != and combine with && || ! and parentheses. Values:");
    for (const ConditionVariable& variable : conditionVariables())
        letters +=
            QStringLiteral("\n%1: %2").arg(QLatin1Char(variable.letter)).arg(coreText(variable.meaning));
    m_condition->setToolTip(letters);
    m_condition->setPlaceholderText(QStringLiteral("Z < -20 && T == 3"));
    m_condition->setAccessibleName(tr("Condition"));
    m_kind->setAccessibleName(tr("Breakpoint type"));
    m_line->setAccessibleName(tr("Line"));
    m_line->setToolTip(
        tr("Stop before this line\nRange: 1 to %1\nDefault: 1").arg(locale().toString(kLastLine)));
    m_height->setAccessibleName(tr("Height"));
    m_height->setToolTip(
        tr("Stop before a block that moves below this height\nRange: %1 to %2 mm\nDefault: 0 mm")
            .arg(locale().toString(-kFarthest), locale().toString(kFarthest)));
    m_add->setText(tr("Add"));
    m_add->setToolTip(tr("Add this breakpoint; to add one in the editor, click a line number"));
    m_remove->setText(tr("Remove"));
    m_remove->setToolTip(tr("Remove the selected breakpoints"));
    m_list->setAccessibleName(tr("Breakpoints"));
    m_list->setHeaderLabels({tr("Stop at"), tr("Value")});
    showKind();
    showBreakpoints();
}

void BreakpointsPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    else if (event->type() == QEvent::PaletteChange)
        colourProblem();
}

} // namespace proveout
