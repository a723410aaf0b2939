// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/control/control_panel.h"

#include <string_view>

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "core/nc/program/control_names.h"
#include "core/simulation/run/interpretation.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/panel_layout.h"
#include "ui/readout/tool_actions.h"

namespace proveout {

namespace {

constexpr int kRestMs = 120;
constexpr int kColumns = 3;
constexpr int kValueColumn = 1;
constexpr int kMeaningColumn = 2;
constexpr int kWide = 420; // px; from this width on the meanings are shown too
constexpr int kIndentation = 14;
constexpr int kNarrowest = 40; // px, of a column

QString coordinate(const QLocale& locale, const ControlState::Place& place, int axis) {
    const bool known = (place.known >> static_cast<unsigned>(axis) & 1U) != 0;
    return known ? locale.toString(place.value[axis], 'f', 3) : QStringLiteral("–");
}

bool isNothing(const ControlState::Place& place) {
    return place.known == kAllAxes && place.value == Vec3(0);
}

} // namespace

ControlPanel::ControlPanel(Session& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_tree(new QTreeWidget(this)), m_empty(wrappedLabel(this)) {
    m_tree->setColumnCount(kColumns);
    m_tree->setRootIsDecorated(true);
    m_tree->setUniformRowHeights(true);
    m_tree->setAlternatingRowColors(true);
    m_tree->setSelectionMode(QAbstractItemView::SingleSelection);
    m_tree->setIndentation(kIndentation);
    m_tree->header()->setMinimumSectionSize(kNarrowest);
    m_tree->header()->setStretchLastSection(false);
    m_tree->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_tree->header()->setSectionResizeMode(QHeaderView::Stretch);
    m_tree->header()->setSectionResizeMode(kValueColumn, QHeaderView::ResizeToContents);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_empty);
    layout->addWidget(m_tree);
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestMs);
    connect(&m_rest, &QTimer::timeout, this, &ControlPanel::ask);
    connect(&m_source, &ProgramSource::ready, this, &ControlPanel::adopt);
    connect(&session.playback(), &PlaybackHub::tick, this, [this] { m_rest.start(); });
    connect(&session.program(), &ProgramHub::changed, this, [this] { m_rest.start(); });
    connect(&session.job(), &JobHub::setupChanged, this, [this] {
        if (m_shown)
            fill(m_shown->controlState()); // the assumed tool may have changed
    });
    connect(m_tree, &QTreeWidget::itemActivated, this, [this](const QTreeWidgetItem* item) {
        if (const int line = item->data(0, Qt::UserRole).toInt(); line > 0)
            emit m_session.navigation().lineRequested(static_cast<std::uint32_t>(line), 1);
    });
    retranslate();
}

void ControlPanel::retranslate() {
    m_tree->setAccessibleName(tr("Control state"));
    m_tree->setHeaderLabels({tr("Name"), tr("Value"), tr("Meaning")});
    m_empty->setText(
        tr("Open a program to see the modal codes, offsets and variables at the current block."));
    if (m_shown)
        fill(m_shown->controlState());
    m_empty->setVisible(!m_shown);
    m_tree->setVisible(m_shown != nullptr);
}

/// Interprets nothing while the panel is hidden or the block has not changed.
void ControlPanel::ask() {
    const auto& program = m_session.program().current();
    const FramePtr frame = m_session.simulation().frame();
    if (!isVisible() || !program || (frame && frame->program != program))
        return;
    const std::size_t block = frame ? frame->block : 0;
    if (m_askedOf == program && m_askedBlock == block)
        return;
    m_askedOf = program;
    m_askedBlock = block;
    InterpretOptions options =
        interpretOptions(m_session.job().setup(), m_session.document().text().path, *program);
    options.stopAfterBlocks = block;
    m_source.request(m_session.document().text().text, std::move(options));
}

void ControlPanel::adopt(const std::shared_ptr<const Program>& program) {
    m_shown = program;
    m_empty->hide();
    m_tree->show();
    fill(program->controlState());
}

QTreeWidgetItem* ControlPanel::section(const QString& title) {
    auto* item = new QTreeWidgetItem(m_tree, {title});
    QFont font = item->font(0);
    font.setBold(true);
    item->setFont(0, font);
    item->setFirstColumnSpanned(true);
    item->setExpanded(true);
    return item;
}

QTreeWidgetItem& ControlPanel::addRow(QTreeWidgetItem& parent, const QString& name, const QString& value,
                                      const QString& meaning) {
    auto* row = new QTreeWidgetItem(&parent, {name, value, meaning});
    for (int column = 0; column < kColumns; ++column)
        row->setToolTip(column, meaning.isEmpty() ? row->text(column) : meaning);
    return *row;
}

/// A tool that is assumed to be in the spindle also counts as the control's spindle tool.
QString ControlPanel::valueText(const ControlState::Quantity& quantity) const {
    if (quantity.name == std::string_view(control_name::kSpindleTool))
        return toolText(static_cast<int>(quantity.value), toolChoice(m_session),
                        m_session.job().setup().tools);
    return QStringLiteral("%1 %2").arg(locale().toString(quantity.value, 'g', 7), coreText(quantity.unit));
}

void ControlPanel::fill(const ControlState& state) {
    m_tree->setUpdatesEnabled(false);
    m_tree->clear();
    if (!state.calls.empty()) {
        QTreeWidgetItem* calls = section(tr("Calls"));
        for (const ControlState::Call& call : state.calls) {
            QTreeWidgetItem& row = addRow(
                *calls, QStringLiteral("O%1").arg(QString::fromStdString(call.program)),
                tr("from line %1").arg(locale().toString(call.line)), QString::fromStdString(call.file));
            if (call.file.empty())
                row.setData(0, Qt::UserRole, call.line);
        }
    }
    QTreeWidgetItem* modes = section(tr("Modal codes"));
    for (const ControlState::Mode& mode : state.modes)
        addRow(*modes, coreText(mode.group), QString::fromStdString(mode.code), coreText(mode.name));
    QTreeWidgetItem* places = section(tr("Position and offsets (mm)"));
    for (const ControlState::Place& place : state.places) {
        QTreeWidgetItem& row =
            addRow(*places, coreText(place.name), isNothing(place) ? locale().toString(0) : QString());
        for (int axis = 0; axis < 3 && !isNothing(place); ++axis)
            addRow(row, QString(QChar(u'X' + axis)), coordinate(locale(), place, axis));
    }
    for (const ControlState::Quantity& quantity : state.quantities)
        addRow(*places, coreText(quantity.name), valueText(quantity));
    if (!state.variables.empty()) {
        QTreeWidgetItem* variables = section(tr("Variables"));
        for (const ControlState::Variable& variable : state.variables)
            addRow(*variables, QString::fromStdString(variable.name),
                   locale().toString(variable.value, 'g', 10));
    }
    m_tree->expandAll();
    m_tree->setUpdatesEnabled(true);
}

void ControlPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

void ControlPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    m_tree->setColumnHidden(kMeaningColumn, width() < kWide);
}

void ControlPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    m_rest.start();
}

} // namespace proveout
