// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/part/part_panel.h"

#include <memory>

#include <QEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QScrollArea>
#include <QSortFilterProxyModel>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

#include "core/base/atomic_file.h"
#include "ui/document/file_paths.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/elided_label.h"
#include "ui/part/deviation_chart.h"
#include "ui/part/islands_model.h"
#include "ui/part/part_form.h"
#include "ui/part/part_text.h"

namespace proveout {

namespace {

constexpr int kFormWidth = 270; ///< px
constexpr int kHeight = 230;
constexpr double kRadiusOfPlace = 2; // mm: what is to be seen around an island

} // namespace

PartPanel::PartPanel(Session& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_form(new PartForm(session)), m_result(new ElidedLabel(this)),
      m_csv(new QToolButton(this)), m_model(new IslandsModel(this)), m_order(new QSortFilterProxyModel(this)),
      m_view(new QTreeView(this)), m_empty(new QLabel(this)), m_chart(new DeviationChart(this)) {
    build();
    connect(m_view, &QTreeView::activated, this, &PartPanel::goTo);
    connect(m_csv, &QToolButton::clicked, this, &PartPanel::saveCsv);
    connect(&session.check(), &CheckHub::changed, this, &PartPanel::showResult);
    connect(&session.part(), &PartHub::partChanged, this, &PartPanel::showResult);
    connect(&session.job(), &JobHub::partChanged, this, &PartPanel::showResult);
    connect(&session.document(), &DocumentHub::changed, this, &PartPanel::showResult);
    retranslate();
}

void PartPanel::build() {
    auto* form = new QScrollArea(this);
    form->setWidget(m_form);
    form->setWidgetResizable(true);
    form->setFrameShape(QFrame::NoFrame);
    form->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    form->setFixedWidth(kFormWidth);
    auto* top = new QHBoxLayout;
    top->setContentsMargins(0, 2, 8, 2);
    top->addWidget(m_result, 1);
    top->addWidget(m_csv);
    auto* middle = new QVBoxLayout;
    middle->setSpacing(0);
    middle->addLayout(top);
    middle->addWidget(m_view, 1);
    middle->addWidget(m_empty, 1);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(form);
    layout->addLayout(middle, 1);
    layout->addWidget(m_chart);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_empty->setObjectName(QStringLiteral("part-empty"));
    m_result->setObjectName(QStringLiteral("part-result"));
    m_csv->setObjectName(QStringLiteral("part-csv"));
    m_order->setSourceModel(m_model);
    m_order->setSortRole(IslandsModel::kSortRole);
    m_view->setObjectName(QStringLiteral("islands"));
    m_view->setModel(m_order);
    m_view->setRootIsDecorated(false);
    m_view->setUniformRowHeights(true);
    m_view->setAlternatingRowColors(true);
    m_view->header()->setStretchLastSection(false);
    m_view->header()->setSortIndicator(IslandsModel::kDepth, Qt::DescendingOrder); // the deepest first
    m_view->setSortingEnabled(true);
}

QSize PartPanel::sizeHint() const {
    return {QWidget::sizeHint().width(), kHeight};
}

/// Why there is no result; empty if there is one.
QString PartPanel::state() const {
    const CheckHub& check = m_session.check();
    if (!m_session.document().isOpen())
        return tr("Open a program, then choose the part that it makes.");
    if (!m_session.job().part())
        return tr("Choose the part that the program makes: the stock is then compared with it.");
    if (m_session.part().isReading())
        return tr("Reading the part…");
    if (const PartContents& contents = m_session.part().contents(); contents.part == nullptr)
        return contents.findings.empty() ? tr("There is not enough memory for the part.")
                                         : sentence(contents.findings.front());
    if (check.progress())
        return tr("Checking the program and comparing the stock…");
    if (!check.refusal().empty())
        return sentence(check.refusal().front());
    if (!check.report())
        return tr("The program is not checked.");
    if (check.report()->part == nullptr)
        return tr("The stock is not compared with the part: see the problems.");
    return check.report()->part->islands.empty() ? tr("Nothing is out of tolerance.") : QString();
}

void PartPanel::showResult() {
    const std::shared_ptr<const CheckReport>& report = m_session.check().report();
    const auto comparison = report ? report->part : nullptr;
    m_model->setComparison(comparison);
    m_chart->setComparison(comparison);
    m_chart->setVisible(comparison != nullptr);
    const QString why = state();
    m_view->setVisible(why.isEmpty());
    m_empty->setVisible(!why.isEmpty());
    m_empty->setText(why);
    m_result->setText(comparison ? resultText(*comparison) : QString());
    m_result->setToolTip(m_result->text());
    m_csv->setEnabled(comparison && !comparison->islands.empty());
    if (why.isEmpty())
        for (int column = 0; column < IslandsModel::kColumnCount; ++column)
            m_view->resizeColumnToContents(column);
}

/// Shows the place, and the block that made it.
void PartPanel::goTo(const QModelIndex& index) {
    const ComparedIsland& island = m_model->island(m_order->mapToSource(index).row());
    if (island.block) {
        emit m_session.navigation().lineRequested(static_cast<std::uint32_t>(island.line), 1);
        m_session.playback().seek(*island.block + 1);
    }
    emit m_session.navigation().placeRequested(island.of.place, kRadiusOfPlace);
}

void PartPanel::saveCsv() {
    const std::shared_ptr<const CheckReport> report = m_session.check().report();
    const QString file = QFileDialog::getSaveFileName(this, tr("Save Islands"), QStringLiteral("islands.csv"),
                                                      tr("Table (%1)").arg(QStringLiteral("*.csv")));
    if (file.isEmpty() || !report || !report->part)
        return;
    AtomicFile out(toPath(file));
    out.write(islandsCsv(*report->part));
    if (auto done = out.commit(); !done)
        m_session.problems().report(done.error());
}

void PartPanel::retranslate() {
    m_csv->setText(tr("Save CSV…"));
    m_csv->setToolTip(tr("Save the islands as a table"));
    m_view->setAccessibleName(tr("Places out of tolerance"));
    showResult();
}

void PartPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace proveout
