// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/closer_look_form.h"

#include <cmath>

#include <QDoubleSpinBox>
#include <QEvent>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QSignalBlocker>
#include <QToolButton>

#include "ui/look/number_box.h"
#include "ui/viewport/box_choice.h"

namespace proveout {
namespace {

constexpr double kLeastSpacing = 1e-4; // mm
constexpr double kMostSpacing = 10;
constexpr int kSizeDecimals = 3;
constexpr int kSpacingDecimals = 4;
constexpr double kMostSize = 1e4;
constexpr int kProgressSteps = 100;
constexpr int kTextWidth = 260; // px

QDoubleSpinBox* lengthBox(QWidget* parent, double least, double most, int decimals, double step) {
    auto* box = new NumberBox(parent);
    box->setDecimals(decimals);
    box->setRange(least, most);
    box->setSingleStep(step);
    box->setSuffix(QStringLiteral(" mm"));
    return box;
}

/// Keeps text that is being typed as long as the value is the same.
void showLength(QDoubleSpinBox& box, double value) {
    const QSignalBlocker quiet(box);
    if (std::abs(box.value() - value) > 0.5 * std::pow(0.1, box.decimals()))
        box.setValue(value);
}

} // namespace

CloserLookForm::CloserLookForm(CloserLook& look, QWidget* parent)
    : QFrame(parent), m_look(look), m_sizeLabel(new QLabel(this)),
      m_width(lengthBox(this, kLeastBoxSide, kMostSize, kSizeDecimals, 1)),
      m_depth(lengthBox(this, kLeastBoxSide, kMostSize, kSizeDecimals, 1)), m_spacingLabel(new QLabel(this)),
      m_spacing(lengthBox(this, kLeastSpacing, kMostSpacing, kSpacingDecimals, 0.005)),
      m_progress(new QProgressBar(this)), m_cancel(new QToolButton(this)), m_again(new QToolButton(this)),
      m_close(new QToolButton(this)), m_status(new QLabel(this)) {
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    m_again->setObjectName(QStringLiteral("closerAgain"));
    m_width->setObjectName(QStringLiteral("closerWidth"));
    m_depth->setObjectName(QStringLiteral("closerDepth"));
    m_spacing->setObjectName(QStringLiteral("closerSpacing"));
    m_width->setValue(kDefaultBox);
    m_depth->setValue(kDefaultBox);
    m_spacing->setValue(BoxOfInterest().spacing);
    m_progress->setRange(0, kProgressSteps);
    m_progress->setTextVisible(false);
    m_status->setWordWrap(true);
    m_status->setMinimumWidth(kTextWidth);
    m_sizeLabel->setBuddy(m_width);
    m_spacingLabel->setBuddy(m_spacing);
    auto* layout = new QGridLayout(this);
    layout->addWidget(m_sizeLabel, 0, 0);
    layout->addWidget(m_width, 0, 1);
    layout->addWidget(m_depth, 0, 2);
    layout->addWidget(m_spacingLabel, 1, 0);
    layout->addWidget(m_spacing, 1, 1);
    layout->addWidget(m_close, 1, 2, Qt::AlignRight);
    layout->addWidget(m_progress, 2, 0, 1, 2);
    layout->addWidget(m_cancel, 2, 2, Qt::AlignRight);
    layout->addWidget(m_again, 2, 2, Qt::AlignRight); // only one of the two is shown
    layout->addWidget(m_status, 3, 0, 1, 3);
    for (QDoubleSpinBox* box : {m_width, m_depth, m_spacing})
        connect(box, &QDoubleSpinBox::valueChanged, this, &CloserLookForm::edited);
    connect(m_cancel, &QToolButton::clicked, &look, &CloserLook::cancel);
    connect(m_again, &QToolButton::clicked, &look, &CloserLook::again);
    connect(m_close, &QToolButton::clicked, this, &CloserLookForm::closed);
    connect(&look, &CloserLook::changed, this, &CloserLookForm::showState);
    retranslate();
    showState();
}

Vec2 CloserLookForm::size() const {
    return {m_width->value(), m_depth->value()};
}

double CloserLookForm::spacing() const {
    return m_spacing->value();
}

void CloserLookForm::retranslate() {
    setAccessibleName(tr("Magnifier"));
    m_sizeLabel->setText(tr("Box:"));
    m_spacingLabel->setText(tr("Grid spacing:"));
    m_width->setAccessibleName(tr("Box size in X"));
    m_depth->setAccessibleName(tr("Box size in Y"));
    m_spacing->setAccessibleName(tr("Grid spacing in the box"));
    const QLocale locale;
    const auto tip = [&](QDoubleSpinBox& box, const QString& what, double defaultValue) {
        box.setToolTip(tr("%1 From %2 to %3 mm. Default: %4 mm.")
                           .arg(what, locale.toString(box.minimum()), locale.toString(box.maximum()),
                                locale.toString(defaultValue)));
    };
    tip(*m_width, tr("Size of the box in X; a click makes a box of this size."), kDefaultBox);
    tip(*m_depth, tr("Size of the box in Y; a click makes a box of this size."), kDefaultBox);
    tip(*m_spacing, tr("Distance between the grid points in the box."), BoxOfInterest().spacing);
    m_cancel->setText(tr("Cancel"));
    m_cancel->setToolTip(tr("Cancel this task"));
    m_again->setText(tr("Cut Again"));
    m_again->setToolTip(tr("Cut the cancelled box again"));
    m_close->setText(tr("Close"));
    m_close->setToolTip(tr("Close (Esc)"));
}

void CloserLookForm::showState() {
    if (const auto& box = m_look.box()) {
        const Vec2 size = box->box.hi - box->box.lo;
        showLength(*m_width, size.x);
        showLength(*m_depth, size.y);
    }
    m_progress->setVisible(m_look.working());
    m_progress->setValue(static_cast<int>(std::lround(m_look.done() * kProgressSteps)));
    m_cancel->setVisible(m_look.working());
    m_again->setVisible(m_look.isLeft());
    m_status->setText(m_look.status());
    // Updates the layout immediately and not in the next event loop turn, because the view positions the form
    // by its size.
    layout()->activate();
    adjustSize();
}

void CloserLookForm::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape)
        emit closed();
    else
        QFrame::keyPressEvent(event);
}

void CloserLookForm::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        showState();
    }
    QFrame::changeEvent(event);
}

} // namespace proveout
