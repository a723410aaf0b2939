// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/setup/control_form.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <type_traits>

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "core/nc/codes/dialects.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/field_text.h"
#include "ui/setup/ignored_codes_field.h"
#include "ui/setup/start_form.h"

namespace proveout {

namespace {

template<class Value>
constexpr bool kHasOwnForm =
    std::is_same_v<Value, std::optional<Vec3>> || std::is_same_v<Value, std::optional<int>> ||
    std::is_same_v<Value, std::optional<DialectId>> || std::is_same_v<Value, std::set<int>>;

/// Calls `visit(value, field, index)` for each row that is an on/off setting or has two choices.
template<class Params, class Visitor>
void eachSwitch(Params& setup, Visitor&& visit) {
    std::size_t index = 0;
    describeControl(setup, [&](auto& value, const Field& field) {
        using Value = std::remove_cvref_t<decltype(value)>;
        static_assert(std::is_same_v<Value, bool> || kHasOwnForm<Value>, "a row without a widget");
        if constexpr (std::is_same_v<Value, bool>)
            visit(value, field, index++);
    });
}

} // namespace

ControlForm::ControlForm(Session& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_dialectLabel(new QLabel(this)), m_dialect(new QComboBox(this)) {
    build();
    connect(m_dialect, &QComboBox::activated, this, &ControlForm::edited);
    connect(m_ignored, &IgnoredCodesField::edited, this, &ControlForm::edited);
    connect(m_start, &StartForm::edited, this, &ControlForm::edited);
    retranslate();
}

void ControlForm::build() {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    m_dialectLabel->setBuddy(m_dialect);
    m_dialect->setObjectName(QLatin1String(optionOf(setup_field::kDialect)));
    m_dialect->addItem(QString()); // see automaticDialect()
    for (const Dialect& row : dialects())
        m_dialect->addItem(QString::fromUtf8(row.name));
    layout->addWidget(m_dialectLabel);
    layout->addWidget(m_dialect);
    // Combo boxes are above check boxes, and created in that sequence, because the Tab key follows it.
    addSwitches(*layout, [](const Field& field) { return !field.choices.empty(); });
    addSwitches(*layout, [](const Field& field) { return field.choices.empty(); });
    m_ignored = new IgnoredCodesField(this);
    m_start = new StartForm(this);
    layout->addWidget(m_ignored);
    layout->addWidget(m_start);
}

void ControlForm::addSwitches(QVBoxLayout& layout, bool (*wanted)(const Field&)) {
    const Setup defaults;
    eachSwitch(defaults, [&](bool, const Field& field, std::size_t index) {
        m_switches.resize(std::max(m_switches.size(), index + 1));
        if (wanted(field))
            m_switches[index] = makeSwitch(field, layout);
    });
}

ControlForm::Switch ControlForm::makeSwitch(const Field& field, QVBoxLayout& layout) {
    Switch made{&field};
    if (field.choices.empty()) {
        made.box = new QCheckBox(this);
        made.box->setObjectName(QLatin1String(optionOf(field)));
        layout.addWidget(made.box);
        connect(made.box, &QCheckBox::toggled, this, &ControlForm::edited);
        return made;
    }
    made.label = new QLabel(this);
    made.choices = new QComboBox(this);
    made.choices->setObjectName(QLatin1String(optionOf(field)));
    made.choices->addItems({QString(), QString()});
    made.label->setBuddy(made.choices);
    layout.addWidget(made.label);
    layout.addWidget(made.choices);
    connect(made.choices, &QComboBox::activated, this, &ControlForm::edited);
    return made;
}

void ControlForm::show(const Setup& setup) {
    eachSwitch(setup, [this](bool on, const Field&, std::size_t index) {
        const Switch& row = m_switches[index];
        if (row.box == nullptr) {
            row.choices->setCurrentIndex(on ? 1 : 0);
            return;
        }
        const QSignalBlocker quiet(row.box);
        row.box->setChecked(on);
    });
    m_ignored->show(setup);
    m_dialect->setCurrentIndex(setup.dialect ? static_cast<int>(*setup.dialect) + 1 : 0);
    showProgram(setup);
}

void ControlForm::dropText() {
    m_ignored->dropText();
}

void ControlForm::put(Setup& setup) const {
    m_start->put(setup);
    eachSwitch(setup, [this](bool& on, const Field&, std::size_t index) {
        const Switch& row = m_switches[index];
        on = row.box == nullptr ? row.choices->currentIndex() == 1 : row.box->isChecked();
    });
    m_ignored->put(setup);
    setup.dialect.reset();
    if (const int index = m_dialect->currentIndex(); index > 0)
        setup.dialect = static_cast<DialectId>(index - 1);
}

void ControlForm::showProgram(const Setup& setup) {
    m_start->show(setup, m_session.program().current().get());
    m_ignored->showProgram(m_session.program().current().get());
    m_dialect->setItemText(0, automaticDialect());
    showCompensation();
}

/// The dialect that was detected in the text, named once it is known.
QString ControlForm::automaticDialect() const {
    const auto& program = m_session.program().current();
    if (!program || m_session.job().setup().dialect)
        return tr("Automatic");
    if (program->foreignKind() != nullptr)
        return tr("Automatic: none of these");
    return tr("Automatic: %1").arg(QString::fromUtf8(dialect(program->dialect()).name));
}

/// Visible only for controls that have this setting.
void ControlForm::showCompensation() {
    const auto& chosen = m_session.job().setup().dialect;
    const bool known = chosen || m_session.program().current();
    const bool shown =
        known && dialect(chosen ? *chosen : m_session.program().current()->dialect()).vectors.used;
    const auto row = std::ranges::find(m_switches, &setup_field::kCompensationStart, &Switch::field);
    row->label->setVisible(shown);
    row->choices->setVisible(shown);
}

void ControlForm::retranslate() {
    m_dialectLabel->setText(coreText(setup_field::kDialect.label));
    showFieldTexts(*m_dialect, setup_field::kDialect);
    for (const Switch& row : m_switches) {
        if (row.box != nullptr) {
            row.box->setText(coreText(row.field->label));
            showFieldTexts(*row.box, *row.field);
            continue;
        }
        row.label->setText(coreText(row.field->label));
        showFieldTexts(*row.choices, *row.field);
        for (int i = 0; i < row.choices->count(); ++i)
            row.choices->setItemText(i, coreText(row.field->choices[static_cast<std::size_t>(i)].label));
    }
    m_dialect->setItemText(0, automaticDialect());
}

void ControlForm::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace proveout
