// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/study_panel.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

#include <QComboBox>
#include <QEvent>
#include <QFileDialog>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "core/base/atomic_file.h"
#include "core/study/study_csv.h"
#include "ui/document/file_paths.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/panel_layout.h"
#include "ui/study/chart_view.h"

namespace proveout {

namespace {

/// Text of the core, translated.
std::string words(const char* text) {
    return coreText(text).toStdString();
}

/// The formats for exporting a chart; the first one is used for unknown extensions.
struct FigureFormat {
    const char* ending;
    QByteArray (*bytes)(const ChartView& view);
};
constexpr std::array kFigureFormats{
    FigureFormat{".svg", [](const ChartView& view) { return view.svg(); }},
    FigureFormat{".png", [](const ChartView& view) { return view.png(); }},
    FigureFormat{".csv",
                 [](const ChartView& view) { return QByteArray::fromStdString(chartCsv(view.chart())); }},
};

QString figurePatterns() {
    QStringList patterns;
    for (const FigureFormat& format : kFigureFormats)
        patterns += u'*' + QLatin1String(format.ending);
    return patterns.join(u' ');
}

} // namespace

StudyPanel::StudyPanel(Session& session, MakeDrawing makeDrawing, QWidget* parent)
    : QWidget(parent), m_session(session), m_runner(std::move(makeDrawing)), m_sweeps(new QComboBox(this)),
      m_run(new QPushButton(this)), m_optimise(new QPushButton(this)), m_cancel(new QPushButton(this)),
      m_use(new QPushButton(this)), m_export(new QPushButton(this)), m_figures(new QComboBox(this)),
      m_progress(new QProgressBar(this)), m_result(wrappedLabel(this)), m_view(new ChartView(this)) {
    auto* controls = new QGridLayout; // beside the chart, which needs the height of a low dock
    controls->addWidget(m_sweeps, 0, 0, 1, 2);
    controls->addWidget(m_run, 1, 0);
    controls->addWidget(m_cancel, 1, 1);
    controls->addWidget(m_optimise, 2, 0);
    controls->addWidget(m_use, 2, 1);
    controls->addWidget(m_figures, 3, 0);
    controls->addWidget(m_export, 3, 1);
    controls->addWidget(m_progress, 4, 0, 1, 2);
    controls->setRowStretch(5, 1);
    auto* drawn = new QVBoxLayout;
    drawn->addWidget(m_result);
    drawn->addWidget(m_view, 1);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addLayout(controls);
    layout->addLayout(drawn, 1);
    m_result->setTextFormat(Qt::PlainText);
    m_result->hide();
    m_result->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_run->setObjectName(QStringLiteral("study-run"));
    m_optimise->setObjectName(QStringLiteral("study-optimise"));
    m_progress->setRange(0, 100);
    QSizePolicy keepsItsPlace = m_progress->sizePolicy();
    keepsItsPlace.setRetainSizeWhenHidden(true);
    m_progress->setSizePolicy(keepsItsPlace);

    for (std::size_t k = 0; k < sweepTable().size(); ++k)
        m_sweeps->addItem(QString());
    m_sweeps->setCurrentIndex(static_cast<int>(SweepKind::allowance));
    setTexts();
    connect(m_run, &QPushButton::clicked, this, &StudyPanel::startSweep);
    connect(m_optimise, &QPushButton::clicked, this, &StudyPanel::startOptimising);
    connect(m_cancel, &QPushButton::clicked, &m_runner, &StudyRunner::cancel);
    connect(m_use, &QPushButton::clicked, this, &StudyPanel::useChoice);
    connect(m_export, &QPushButton::clicked, this, &StudyPanel::askAndExport);
    connect(m_figures, &QComboBox::currentIndexChanged, this, &StudyPanel::refresh);
    connect(&session.program(), &ProgramHub::changed, this, &StudyPanel::enable);
    connect(&m_runner, &StudyRunner::progressed, this,
            [this](double done) { m_progress->setValue(static_cast<int>(100 * done)); });
    connect(&m_runner, &StudyRunner::ran, this, [this](const auto& run) { addRun(*run); });
    connect(&m_runner, &StudyRunner::rehearsed, this, [this](const auto& rehearsal) {
        m_rehearsal = rehearsal;
        showForecast();
    });
    connect(&m_runner, &StudyRunner::measured, this, [this](const Measured& chosen, const Measured& given) {
        const Forecast& choice = cheapest(*m_rehearsal);
        m_measured = {
            {choice.regionCells, choice.period, chosen.median, tr("Measured, chosen").toStdString()},
            {m_subject.base.regionCells, m_subject.base.period, given.median,
             tr("Measured, current").toStdString()}};
        showForecast();
    });
    connect(&m_runner, &StudyRunner::failed, &session.problems(), &ProblemsHub::report);
    connect(&m_runner, &StudyRunner::ended, this, &StudyPanel::enable);
    enable();
}

bool StudyPanel::useJob() {
    if (!m_session.program().current() || m_runner.busy())
        return false;
    m_subject = {{m_session.program().current(), std::make_shared<const Setup>(m_session.job().setup())},
                 m_session.job().parameters(),
                 tr("Rendering time").toStdString(),
                 words};
    m_runs.clear();
    m_rehearsal.reset();
    m_measured.clear();
    m_progress->setValue(0);
    report(QString());
    return true;
}

void StudyPanel::startSweep() {
    if (!useJob())
        return;
    const SweepRow& sweep = sweepTable()[static_cast<std::size_t>(m_sweeps->currentIndex())];
    const QSignalBlocker quiet(m_figures);
    m_figures->clear();
    for (std::size_t k = 0; k < figureTable().size(); ++k)
        if (figureTable()[k].sweep == sweep.kind)
            m_figures->addItem(tr("Fig. %1").arg(QLatin1String(figureTable()[k].paper)), static_cast<int>(k));
    std::vector<StudyPoint> points = sweep.points(m_subject);
    if (points.empty())
        report(tr("This sweep does not apply to the current decimation method."));
    else
        m_runner.sweep(m_subject.job, std::move(points));
    refresh();
    enable();
}

void StudyPanel::startOptimising() {
    if (!useJob())
        return;
    const QSignalBlocker quiet(m_figures);
    m_figures->clear();
    m_runner.optimise(m_subject.job, m_subject.base);
    enable();
}

void StudyPanel::addRun(const StudyRun& run) {
    m_runs.push_back(run);
    refresh();
}

void StudyPanel::refresh() {
    const QVariant figure = m_figures->currentData();
    if (!figure.isValid())
        return;
    const FigureRow& row = figureTable()[static_cast<std::size_t>(figure.toInt())];
    Chart chart = row.chart(m_subject, m_runs);
    chart.id = row.id;
    chart.title = words(row.title);
    m_view->setChart(chart);
}

void StudyPanel::showForecast() {
    m_view->setChart(forecastChart(*m_rehearsal, m_measured, words));
    const Forecast& choice = cheapest(*m_rehearsal);
    const QLocale locale;
    QString text = tr("Region size %1, period %2: predicted %3 s, without decimation %4 s")
                       .arg(choice.regionCells)
                       .arg(choice.period)
                       .arg(locale.toString(choice.seconds, 'f', 2),
                            locale.toString(m_rehearsal->undecimated.seconds, 'f', 2));
    if (!m_measured.empty())
        text += QLatin1String("; ") + tr("measured %1 s, with the current parameters %2 s")
                                          .arg(locale.toString(m_measured[0].seconds, 'f', 2),
                                               locale.toString(m_measured[1].seconds, 'f', 2));
    report(text);
    enable();
}

void StudyPanel::report(const QString& text) {
    m_result->setText(text);
    m_result->setVisible(!text.isEmpty()); // otherwise the chart gets its line
}

void StudyPanel::useChoice() {
    if (!m_rehearsal)
        return;
    m_session.job().asOneStep([this] {
        m_session.job().setParameters(withSchedule(m_session.job().parameters(), cheapest(*m_rehearsal)));
    });
}

bool StudyPanel::exportTo(const QString& file) {
    const auto named = std::ranges::find_if(kFigureFormats, [&file](const FigureFormat& format) {
        return file.endsWith(QLatin1String(format.ending), Qt::CaseInsensitive);
    });
    const FigureFormat& format = named == kFigureFormats.end() ? kFigureFormats.front() : *named;
    const auto written = writeFile(toPath(file), format.bytes(*m_view).toStdString());
    if (!written)
        m_session.problems().report(written.error());
    return written.has_value();
}

void StudyPanel::askAndExport() {
    const QString file = QFileDialog::getSaveFileName(this, tr("Export Figure"),
                                                      QString::fromStdString(m_view->chart().id) +
                                                          QLatin1String(kFigureFormats.front().ending),
                                                      tr("Figures (%1)").arg(figurePatterns()));
    if (!file.isEmpty())
        exportTo(file);
}

void StudyPanel::enable() {
    const bool busy = m_runner.busy();
    const bool possible = !busy && m_session.program().blockCount() > 0;
    m_run->setEnabled(possible);
    m_optimise->setEnabled(possible);
    m_sweeps->setEnabled(!busy);
    m_cancel->setEnabled(busy);
    m_progress->setVisible(busy);
    m_use->setEnabled(m_rehearsal != nullptr);
    m_figures->setEnabled(m_figures->count() > 0);
    m_export->setEnabled(!m_view->empty());
}

void StudyPanel::setTexts() {
    setAccessibleName(tr("Study"));
    for (std::size_t k = 0; k < sweepTable().size(); ++k)
        m_sweeps->setItemText(static_cast<int>(k), coreText(sweepTable()[k].title));
    m_sweeps->setToolTip(tr("What the sweep varies"));
    m_view->setPlaceholder(tr("Run a sweep to see its figures here."));
    m_figures->setToolTip(tr("Figure of the paper to draw"));
    m_run->setText(tr("&Run Sweep"));
    m_run->setToolTip(tr("Run the program once for each point of the paper's curves"));
    m_optimise->setText(tr("&Optimise"));
    m_optimise->setToolTip(tr("Choose region size and period from a short trial run, then measure them"));
    m_use->setText(tr("&Use"));
    m_use->setToolTip(tr("Use the chosen region size and period"));
    m_cancel->setText(tr("&Cancel"));
    m_export->setText(tr("&Export…"));
}

void StudyPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        setTexts();
    QWidget::changeEvent(event);
}

} // namespace proveout
