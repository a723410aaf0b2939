// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/setup/ignored_codes_field.h"

#include <utility>

#include <QEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QStringList>
#include <QVBoxLayout>

#include "core/simulation/setup/setup_fields.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/field_text.h"
#include "ui/look/panel_layout.h"
#include "ui/look/typed_text.h"

namespace proveout {

IgnoredCodesField::IgnoredCodesField(QWidget* parent)
    : QWidget(parent), m_label(new QLabel(this)), m_list(new QLineEdit(this)), m_problem(wrappedLabel(this)),
      m_found(wrappedLabel(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    for (QWidget* widget : {static_cast<QWidget*>(m_label), static_cast<QWidget*>(m_list),
                            static_cast<QWidget*>(m_problem), static_cast<QWidget*>(m_found)})
        layout->addWidget(widget);
    m_label->setBuddy(m_list);
    m_list->setObjectName(QStringLiteral("ignored-m"));
    m_found->setObjectName(QStringLiteral("ignored-m-found"));
    m_problem->setObjectName(QStringLiteral("ignored-m-problem"));
    m_found->setForegroundRole(QPalette::PlaceholderText);
    m_problem->hide();
    connect(m_list, &QLineEdit::editingFinished, this, &IgnoredCodesField::finish);
    retranslate();
}

/// An invalid text stays for correction, unless the codes were changed elsewhere.
void IgnoredCodesField::show(const Setup& setup) {
    const bool another = std::exchange(m_shown, setup.ignoredM) != setup.ignoredM;
    if (isBeingTyped(*m_list) || (!m_problem->isHidden() && !another))
        return;
    m_list->setText(QString::fromStdString(formatMCodes(setup.ignoredM)));
    m_problem->hide();
}

void IgnoredCodesField::dropText() {
    m_list->setText(QString::fromStdString(formatMCodes(m_shown)));
    m_problem->hide();
}

void IgnoredCodesField::showProgram(const Program* program) {
    m_ignored = program == nullptr ? IgnoredCodes() : program->ignoredCodes();
    QStringList found;
    for (const auto& [number, code] : m_ignored) {
        found
            << (*code.name == '\0'
                    ? tr("M%1 (%2×)").arg(number).arg(locale().toString(code.count))
                    : tr("M%1 %2 (%3×)").arg(number).arg(coreText(code.name), locale().toString(code.count)));
    }
    m_found->setText(tr("Ignored in this program: %1").arg(found.join(QStringLiteral("; "))));
    m_found->setVisible(!found.empty());
}

void IgnoredCodesField::put(Setup& setup) const {
    if (const auto codes = parseMCodes(m_list->text().toStdString()))
        setup.ignoredM = *codes;
}

/// An invalid text is kept, so that the user can correct it.
void IgnoredCodesField::finish() {
    const auto codes = parseMCodes(m_list->text().toStdString());
    m_problem->setVisible(!codes);
    m_list->setModified(!codes);
    if (codes)
        emit edited();
    else
        m_problem->setText(sentence(codes.error().front()));
}

void IgnoredCodesField::retranslate() {
    m_label->setText(coreText(setup_field::kIgnoredM.label));
    m_list->setPlaceholderText(tr("for example 16, 24, 25"));
    showFieldTexts(*m_list, setup_field::kIgnoredM);
}

void IgnoredCodesField::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace proveout
