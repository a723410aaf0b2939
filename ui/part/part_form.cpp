// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/part/part_form.h"

#include <algorithm>

#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "ui/document/file_paths.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/elided_label.h"
#include "ui/look/field_text.h"
#include "ui/look/number_box.h"

namespace proveout {

namespace {

constexpr int kRestMs = 250;
constexpr int kBoxWidth = 110;

} // namespace

PartForm::PartForm(Session& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_file(new ElidedLabel(this)), m_choose(new QToolButton(this)),
      m_remove(new QToolButton(this)) {
    build();
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestMs);
    connect(&m_rest, &QTimer::timeout, this, &PartForm::apply);
    connect(m_choose, &QToolButton::clicked, this, &PartForm::askForFile);
    connect(m_remove, &QToolButton::clicked, this,
            [this] { m_session.job().asOneStep([this] { m_session.job().setPart(std::nullopt); }); });
    JobHub& job = session.job();
    connect(&job, &JobHub::inputWanted, this, [this] {
        if (m_rest.isActive())
            apply();
    });
    connect(&job, &JobHub::replaced, &m_rest, &QTimer::stop);
    connect(&job, &JobHub::partChanged, this, &PartForm::showPart);
    connect(&session.document(), &DocumentHub::changed, this, &PartForm::showPart);
    retranslate();
    showPart();
}

void PartForm::build() {
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(8, 4, 8, 4);
    layout->setColumnStretch(1, 1);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_choose);
    buttons->addWidget(m_remove);
    buttons->addStretch();
    layout->addWidget(m_file, 0, 0, 1, 2);
    layout->addLayout(buttons, 1, 0, 1, 2);
    PartSpec fields;
    describe(fields, [&](double&, const Field& field) {
        auto* label = new QLabel(this);
        auto* box = new NumberBox(this);
        box->setObjectName(QStringLiteral("part-") + QLatin1String(field.key));
        setUpBox(*box, field);
        box->setMinimumWidth(kBoxWidth);
        label->setBuddy(box);
        const auto row = static_cast<int>(m_boxes.size()) + 2;
        layout->addWidget(label, row, 0);
        layout->addWidget(box, row, 1);
        connect(box, &QDoubleSpinBox::valueChanged, &m_rest, qOverload<>(&QTimer::start));
        m_labels.push_back(label);
        m_boxes.push_back(box);
    });
    layout->setRowStretch(static_cast<int>(m_boxes.size()) + 2, 1);
    m_file->setObjectName(QStringLiteral("part-name"));
    m_choose->setObjectName(QStringLiteral("part-choose"));
    m_remove->setObjectName(QStringLiteral("part-remove"));
}

void PartForm::askForFile() {
    const QString file = QFileDialog::getOpenFileName(this, tr("Design Part"), QString(),
                                                      tr("Mesh (%1)").arg(QStringLiteral("*.stl")));
    if (!file.isEmpty())
        setFile(file);
}

void PartForm::setFile(const QString& file) {
    PartSpec part = m_session.job().part().value_or(PartSpec());
    part.file = toPath(file);
    m_session.job().asOneStep([&] { m_session.job().setPart(part); });
    m_session.part().reread(); // the same file may have changed
}

void PartForm::showPart() {
    m_rest.stop();
    const std::optional<PartSpec>& part = m_session.job().part();
    PartSpec shown = part.value_or(PartSpec());
    std::size_t row = 0;
    describe(shown, [&](double& value, const Field&) {
        m_boxes[row]->showValue(value);
        m_boxes[row]->setEnabled(part.has_value());
        m_labels[row]->setEnabled(part.has_value());
        ++row;
    });
    const QString file = part ? toQString(part->file) : QString();
    m_file->setText(part ? QFileInfo(file).fileName() : tr("No design part"));
    m_file->setToolTip(file);
    m_choose->setEnabled(m_session.document().isOpen());
    m_remove->setEnabled(part.has_value());
}

void PartForm::apply() {
    m_rest.stop();
    if (!m_session.job().part())
        return;
    PartSpec part = *m_session.job().part();
    std::size_t row = 0;
    describe(part, [&](double& value, const Field&) { readShown(value, *m_boxes[row++]); });
    m_session.job().setPart(part);
}

void PartForm::retranslate() {
    m_choose->setText(tr("Choose…"));
    m_choose->setToolTip(tr("Choose the part that the stock is compared with (STL)"));
    m_remove->setText(tr("Remove"));
    m_remove->setToolTip(tr("Compare the stock with no part"));
    PartSpec defaults;
    std::size_t row = 0;
    describe(defaults, [&](double& value, const Field& field) {
        m_labels[row]->setText(coreText(field.label));
        showFieldTexts(*m_boxes[row], field, fieldNumber(field, value, locale()));
        ++row;
    });
    showPart();
}

void PartForm::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace proveout
