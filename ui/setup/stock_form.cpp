// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/setup/stock_form.h"

#include <array>
#include <cmath>

#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

namespace proveout {

namespace {

constexpr double kLargest = 100'000;
constexpr double kSmallestSize = 0.01;
constexpr double kFinestGrid = 0.001;
constexpr int kBoxWidth = 110;

struct StockField {
    const char* key;
    const char* label;
    const char* help;
    double minimum;
    double& (*place)(Setup&);
};

constexpr std::array<StockField, 7> kFields{{
    {"stock-width", QT_TRANSLATE_NOOP("StockForm", "Width X"),
     QT_TRANSLATE_NOOP("StockForm", "Size of the stock along X."), kSmallestSize,
     [](Setup& setup) -> double& { return setup.stock.width; }},
    {"stock-depth", QT_TRANSLATE_NOOP("StockForm", "Depth Y"),
     QT_TRANSLATE_NOOP("StockForm", "Size of the stock along Y."), kSmallestSize,
     [](Setup& setup) -> double& { return setup.stock.depth; }},
    {"stock-height", QT_TRANSLATE_NOOP("StockForm", "Height Z"),
     QT_TRANSLATE_NOOP("StockForm", "Size of the stock along Z, from its top downwards."), kSmallestSize,
     [](Setup& setup) -> double& { return setup.stock.height; }},
    {"corner-x", QT_TRANSLATE_NOOP("StockForm", "Left edge X"),
     QT_TRANSLATE_NOOP("StockForm", "Program coordinate of the stock's least X."), -kLargest,
     [](Setup& setup) -> double& { return setup.stock.corner.x; }},
    {"corner-y", QT_TRANSLATE_NOOP("StockForm", "Front edge Y"),
     QT_TRANSLATE_NOOP("StockForm", "Program coordinate of the stock's least Y."), -kLargest,
     [](Setup& setup) -> double& { return setup.stock.corner.y; }},
    {"corner-z", QT_TRANSLATE_NOOP("StockForm", "Top Z"),
     QT_TRANSLATE_NOOP("StockForm", "Program coordinate of the stock's top."), -kLargest,
     [](Setup& setup) -> double& { return setup.stock.corner.z; }},
    {"spacing", QT_TRANSLATE_NOOP("StockForm", "Grid spacing"),
     QT_TRANSLATE_NOOP("StockForm", "Wanted distance of the points of the z-map; it is adjusted so that it "
                                    "divides the stock exactly."),
     kFinestGrid, [](Setup& setup) -> double& { return setup.spacing; }},
}};

QString translated(const char* text) {
    return QCoreApplication::translate("StockForm", text);
}

} // namespace

StockForm::StockForm(QWidget* parent) : QWidget(parent) {
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setColumnStretch(1, 1);
    for (std::size_t i = 0; i < kFields.size(); ++i) {
        auto* label = new QLabel(this);
        auto* box = new QDoubleSpinBox(this);
        box->setObjectName(QLatin1String(kFields[i].key));
        box->setDecimals(3);
        box->setRange(kFields[i].minimum, kLargest);
        box->setKeyboardTracking(false);
        box->setMinimumWidth(kBoxWidth); // its own wish is room for the largest number of the range
        box->setStepType(kFields[i].minimum > 0 ? QAbstractSpinBox::AdaptiveDecimalStepType
                                                : QAbstractSpinBox::DefaultStepType);
        label->setBuddy(box);
        layout->addWidget(label, static_cast<int>(i), 0);
        layout->addWidget(box, static_cast<int>(i), 1);
        connect(box, &QDoubleSpinBox::valueChanged, this, &StockForm::edited);
        m_labels.push_back(label);
        m_boxes.push_back(box);
    }
    retranslate();
}

void StockForm::show(const Setup& setup) {
    Setup copy = setup;
    for (std::size_t i = 0; i < kFields.size(); ++i) {
        const QSignalBlocker quiet(m_boxes[i]);
        m_boxes[i]->setValue(kFields[i].place(copy));
    }
}

void StockForm::put(Setup& setup) const {
    for (std::size_t i = 0; i < kFields.size(); ++i) {
        double& place = kFields[i].place(setup);
        // What the box cannot show exactly (a stock of 12.7001 mm) stays as it is until it is edited.
        if (std::abs(place - m_boxes[i]->value()) > 0.0005)
            place = m_boxes[i]->value();
    }
}

void StockForm::retranslate() {
    Setup standard;
    for (std::size_t i = 0; i < kFields.size(); ++i) {
        m_labels[i]->setText(translated(kFields[i].label));
        m_boxes[i]->setSuffix(tr(" mm"));
        m_boxes[i]->setAccessibleName(translated(kFields[i].label));
        m_boxes[i]->setToolTip(tr("%1\nRange: %2 to %3 mm\nDefault: %4 mm")
                                   .arg(translated(kFields[i].help), locale().toString(kFields[i].minimum),
                                        locale().toString(kLargest),
                                        locale().toString(kFields[i].place(standard))));
    }
}

void StockForm::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace proveout
