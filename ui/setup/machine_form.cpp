// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/setup/machine_form.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>

#include "core/simulation/setup/machine_profiles.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/field_text.h"
#include "ui/look/number_box.h"
#include "ui/look/panel_layout.h"
#include "ui/readout/cycle_time_text.h"

namespace proveout {

namespace {

constexpr int kRestMs = 250;
constexpr int kBoxWidth = 124;

} // namespace

MachineForm::MachineForm(Session& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_profiles(new QToolButton(this)), m_profileMenu(new QMenu(this)),
      m_times(wrappedLabel(this)) {
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setColumnStretch(1, 1);
    Machine fields;
    describe(fields, [&](double&, const Field& field) {
        auto* label = new QLabel(this);
        auto* box = new NumberBox(this);
        box->setObjectName(QLatin1String(field.key));
        setUpBox(*box, field);
        box->setMinimumWidth(kBoxWidth); // its default would fit the largest number of the range
        label->setBuddy(box);
        const auto row = static_cast<int>(m_boxes.size()) + 1;
        layout->addWidget(label, row, 0);
        layout->addWidget(box, row, 1);
        connect(box, &QDoubleSpinBox::valueChanged, &m_rest, qOverload<>(&QTimer::start));
        m_labels.push_back(label);
        m_boxes.push_back(box);
    });
    m_profiles->setMenu(m_profileMenu);
    m_profiles->setPopupMode(QToolButton::InstantPopup);
    m_profiles->setToolButtonStyle(Qt::ToolButtonTextOnly);
    m_profiles->setObjectName(QStringLiteral("machine-profiles"));
    layout->addWidget(m_profiles, 0, 0, 1, 2, Qt::AlignLeft);
    layout->addWidget(m_times, static_cast<int>(m_boxes.size()) + 1, 0, 1, 2);
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestMs);
    connect(&m_rest, &QTimer::timeout, this, &MachineForm::apply);
    connect(&session.job(), &JobHub::inputWanted, this, [this] {
        if (m_rest.isActive())
            apply();
    });
    connect(&session.job(), &JobHub::replaced, &m_rest, &QTimer::stop);
    connect(&session.job(), &JobHub::machineChanged, this, &MachineForm::showMachine);
    connect(&session.program(), &ProgramHub::timesChanged, this, &MachineForm::showTimes);
    retranslate();
    showMachine();
}

void MachineForm::showMachine() {
    m_rest.stop();
    Machine machine = m_session.job().machine().value_or(Machine());
    std::size_t row = 0;
    describe(machine, [&](double& value, const Field&) { m_boxes[row++]->showValue(value); });
    showTimes();
}

void MachineForm::showTimes() {
    const auto& times = m_session.program().times();
    QString text = m_session.job().machine() ? QString() : tr("Default machine values.");
    if (times && times->parts.total() > 0) {
        text += (text.isEmpty() ? QString() : QStringLiteral("\n")) +
                tr("Cycle time %1: feed %2, rapid %3, dwell %4, tool changes %5")
                    .arg(clockText(times->parts.total()), clockText(times->parts.feed),
                         clockText(times->parts.rapid), clockText(times->parts.dwell),
                         clockText(times->parts.toolChange));
    }
    m_times->setText(text);
    m_times->setVisible(!text.isEmpty());
}

void MachineForm::apply() {
    m_rest.stop();
    Machine machine = m_session.job().machine().value_or(Machine());
    std::size_t row = 0;
    describe(machine, [&](double& value, const Field&) { readShown(value, *m_boxes[row++]); });
    m_session.job().setMachine(machine);
}

/// The part stays where it is.
void MachineForm::fillProfiles() {
    m_profiles->setText(tr("Profiles"));
    m_profiles->setToolTip(tr("Typical machines by kind and size, to begin with"));
    m_profileMenu->clear();
    for (const MachineProfile& profile : machineProfiles()) {
        QAction* action = m_profileMenu->addAction(coreText(profile.label), this, [this, &profile] {
            m_session.job().asOneStep([&] {
                m_session.job().setMachine(machineOf(profile, m_session.job().machine().value_or(Machine())));
            });
        });
        action->setObjectName(QLatin1String(profile.key));
    }
}

void MachineForm::retranslate() {
    fillProfiles();
    Machine defaults;
    std::size_t row = 0;
    describe(defaults, [&](double& value, const Field& field) {
        m_labels[row]->setText(coreText(field.label));
        const bool any = value == Machine::kNowhere;
        m_boxes[row]->setSpecialValueText(any ? tr("any") : QString());
        showFieldTexts(*m_boxes[row], field, any ? tr("any") : fieldNumber(field, value, locale()));
        ++row;
    });
    showTimes();
}

void MachineForm::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace proveout
