// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/tuning_panel.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>

#include "core/simulation/setup/setup_fields.h"
#include "ui/document/carried_values.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/grid_field.h"
#include "ui/look/icons.h"
#include "ui/look/panel_layout.h"
#include "ui/look/theme.h"
#include "ui/tuning/parameter_form.h"

namespace proveout {

namespace {

constexpr int kRestMs = 150;
constexpr int kIconSize = 16;

} // namespace

TuningPanel::TuningPanel(Session& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_form(new ParameterForm(this)), m_gridLabel(new QLabel(this)),
      m_grid(new GridField(QStringLiteral("grid"), this)), m_problemIcon(new QLabel(this)),
      m_problem(wrappedLabel(this)), m_effectTitle(sectionLabel(this)), m_faces(wrappedLabel(this)),
      m_error(wrappedLabel(this)), m_regions(wrappedLabel(this)), m_heldBack(wrappedLabel(this)) {
    auto* content = new QWidget;
    auto* layout = new QVBoxLayout(content);
    m_form->addRow(m_gridLabel, m_grid);
    layout->addWidget(m_form);
    auto* problem = new QHBoxLayout;
    problem->addWidget(m_problemIcon, 0, Qt::AlignTop);
    problem->addWidget(m_problem, 1);
    layout->addLayout(problem);
    layout->addSpacing(8);
    for (QLabel* label : {m_effectTitle, m_faces, m_error, m_regions, m_heldBack})
        layout->addWidget(label);
    layout->addStretch(1);
    fillScrolled(*this, content);

    showProblem({});
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestMs);
    connect(&m_rest, &QTimer::timeout, this, &TuningPanel::apply);
    connect(&session.job(), &JobHub::inputWanted, this, [this] {
        if (m_rest.isActive())
            apply();
    });
    connect(m_form, &ParameterForm::edited, &m_rest, qOverload<>(&QTimer::start));
    connect(m_form, &ParameterForm::stepEnded, this, [this] {
        if (m_rest.isActive())
            apply();
        m_session.job().history().closeStep();
    });
    connect(m_grid, &GridField::edited, &m_rest, qOverload<>(&QTimer::start));
    connect(&session.job(), &JobHub::replaced, this, &TuningPanel::dropInput);
    connect(&session.job(), &JobHub::parametersChanged, this, &TuningPanel::showParameters);
    connect(&session.job(), &JobHub::setupChanged, this, &TuningPanel::showSetup);
    connect(&session.playback(), &PlaybackHub::tick, this, &TuningPanel::showEffect);
    retranslate();
    dropInput();
    showSetup();
}

void TuningPanel::dropInput() {
    m_rest.stop();
    m_shownParameters = m_session.job().parameters();
    m_form->setValues(m_shownParameters);
    m_shownSetup = m_session.job().setup();
    m_grid->show(m_shownSetup);
}

/// Keeps changes by the user that are not applied yet.
void TuningPanel::showParameters() {
    m_form->setValues(carried(m_session.job().parameters(), m_shownParameters, m_form->values()));
    m_shownParameters = m_session.job().parameters();
}

void TuningPanel::showSetup() {
    Setup edited = m_shownSetup;
    m_grid->put(edited);
    m_grid->show(carried(m_session.job().setup(), m_shownSetup, edited));
    m_shownSetup = m_session.job().setup();
    showProblem({});
    m_form->setPoints(gridPoints(m_shownSetup.stock, m_shownSetup.spacing));
}

void TuningPanel::apply() {
    m_rest.stop();
    m_session.job().setParameters(m_form->values());
    applyGrid();
}

void TuningPanel::applyGrid() {
    Setup setup = m_session.job().setup();
    m_grid->put(setup);
    const Result<void> done = m_session.job().setSetup(setup);
    showProblem(done ? QString() : sentence(done.error().front()));
    if (!done)
        m_grid->show(m_session.job().setup()); // the spacing of the setup, as in all other panels
}

void TuningPanel::showProblem(const QString& text) {
    m_problem->setText(text);
    m_problem->setVisible(!text.isEmpty());
    m_problemIcon->setVisible(!text.isEmpty());
    colourProblem();
}

void TuningPanel::colourProblem() {
    QPalette colours = palette();
    colours.setColor(QPalette::WindowText, meaningColors(colours).error);
    m_problem->setPalette(colours);
    m_problemIcon->setPixmap(icon(QLatin1String(name(Severity::error))).pixmap(kIconSize));
}

void TuningPanel::showEffect(const FramePtr& frame) {
    if (!frame) {
        m_faces->setText(tr("Open a program to see the measured effect."));
        m_error->clear();
        m_regions->clear();
        m_heldBack->clear();
        return;
    }
    m_heldBack->setText(heldBackText(*frame));
    const SurfaceSnapshot& surface = frame->surface;
    const double share = surface.facesFull == 0 ? 0
                                                : 100.0 * static_cast<double>(surface.faces) /
                                                      static_cast<double>(surface.facesFull);
    m_faces->setText(tr("Triangles shown: %1 of %2 (%3 %)")
                         .arg(locale().toString(static_cast<qulonglong>(surface.faces)),
                              locale().toString(static_cast<qulonglong>(surface.facesFull)),
                              locale().toString(share, 'f', 1)));
    m_regions->setText(tr("Regions drawn from the z-map: %1 of %2")
                           .arg(locale().toString(static_cast<qulonglong>(surface.dirtyRegions)),
                                locale().toString(static_cast<qulonglong>(surface.grid.regionCount()))));
    const QString error = locale().toString(surface.largestError(), 'f', 4);
    const QString allowance = locale().toString(frame->parameters.allowance);
    const QString everywhere =
        frame->zmap.walls().empty()
            ? tr("Largest error: %1 mm anywhere, within the allowance of %2 mm")
            : tr("Largest error: %1 mm anywhere but at walls, within the allowance of %2 mm");
    const QString bounded =
        frame->level == ErrorLevel::surface
            ? everywhere
            : tr("Largest error: %1 mm at the z-map points, within the allowance of %2 mm");
    m_error->setText(
        isBounded(frame->parameters)
            ? bounded.arg(error, allowance)
            : tr("Largest error: %1 mm; the allowance of %2 mm is not guaranteed while Certify is off")
                  .arg(error, allowance));
}

QString TuningPanel::heldBackText(const Frame& frame) const {
    const HoldBack* heldBack = m_session.playback().heldBack();
    if (heldBack == nullptr)
        return {};
    const auto with = heldBack->frameSeconds(false);
    const auto without = heldBack->frameSeconds(true);
    const auto milliseconds = [this](double seconds) { return locale().toString(1e3 * seconds, 'f', 2); };
    if (with && without)
        return tr("Decimation is off during playback: a frame takes %1 ms without it and %2 ms with it.")
            .arg(milliseconds(*without), milliseconds(*with));
    return tr("Decimation is off during playback: there are only %1 triangles to draw without it.")
        .arg(locale().toString(static_cast<qulonglong>(frame.surface.facesFull)));
}

void TuningPanel::retranslate() {
    m_gridLabel->setText(coreText(setup_field::kGrid.label));
    m_effectTitle->setText(tr("Measured effect"));
    showEffect(m_session.simulation().frame());
}

void TuningPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::PaletteChange)
        colourProblem();
}

} // namespace proveout
