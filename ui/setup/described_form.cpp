// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/setup/described_form.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include <QCoreApplication>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>

#include "ui/look/diagnostic_text.h"
#include "ui/look/field_text.h"
#include "ui/look/number_box.h"

namespace proveout {

namespace {

constexpr int kBoxWidth = 114;

/// The labels of fixtures; their header does not mark them for translation.
[[maybe_unused]] constexpr const char* kLabels[] = {
    QT_TRANSLATE_NOOP("Core", "Least X"),   QT_TRANSLATE_NOOP("Core", "Least Y"),
    QT_TRANSLATE_NOOP("Core", "Bottom Z"),  QT_TRANSLATE_NOOP("Core", "Width (X)"),
    QT_TRANSLATE_NOOP("Core", "Depth (Y)"), QT_TRANSLATE_NOOP("Core", "Height"),
    QT_TRANSLATE_NOOP("Core", "Axis X"),    QT_TRANSLATE_NOOP("Core", "Axis Y"),
    QT_TRANSLATE_NOOP("Core", "Diameter")};

} // namespace

DescribedForm::DescribedForm(QString prefix, QWidget* parent)
    : QWidget(parent), m_prefix(std::move(prefix)), m_layout(new QFormLayout(this)) {
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setRowWrapPolicy(QFormLayout::WrapLongRows);
}

bool DescribedForm::hasFieldsOf(const std::vector<Shown>& rows) const {
    return std::ranges::equal(
        m_rows, rows, [](const char* a, const char* b) { return std::string_view(a) == b; },
        [](const Row& row) { return row.field.label; }, [](const Shown& shown) { return shown.field.label; });
}

void DescribedForm::showRows(const std::vector<Shown>& rows) {
    if (!hasFieldsOf(rows)) {
        while (m_layout->rowCount() > 0)
            m_layout->removeRow(0);
        m_rows.clear();
        for (const Shown& shown : rows)
            addRow(shown.field);
        retranslate();
    }
    for (std::size_t row = 0; row < rows.size(); ++row)
        m_rows[row].box->showValue(rows[row].value);
}

void DescribedForm::addRow(const Field& field) {
    auto* label = new QLabel(this);
    auto* box = new NumberBox(this);
    setUpBox(*box, field);
    box->setObjectName(m_prefix + QLatin1String(field.key));
    box->setMinimumWidth(kBoxWidth);
    label->setBuddy(box);
    m_layout->addRow(label, box);
    m_rows.push_back({field, label, box});
    connect(box, &QDoubleSpinBox::valueChanged, this, &DescribedForm::edited);
}

void DescribedForm::read(std::size_t row, double& value) const {
    readShown(value, *m_rows[row].box);
}

void DescribedForm::selectFirst() {
    if (m_rows.empty())
        return;
    m_rows.front().box->setFocus();
    m_rows.front().box->selectAll();
}

void DescribedForm::retranslate() {
    for (const Row& row : m_rows) {
        row.label->setText(coreText(row.field.label));
        showFieldTexts(*row.box, row.field);
    }
}

void DescribedForm::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace proveout
