// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/setup/stock_form.h"

#include <array>

#include <QComboBox>
#include <QDir>
#include <QEvent>
#include <QFileDialog>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QToolButton>

#include "core/simulation/setup/setup_fields.h"
#include "ui/document/file_paths.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/field_text.h"
#include "ui/look/grid_field.h"
#include "ui/look/number_box.h"
#include "ui/look/typed_text.h"

namespace proveout {

namespace {

constexpr double kSmallestSize = 0.01;
constexpr int kBoxWidth = 110;

struct PlaceField {
    const char* name; ///< of the widget
    const Field* field;
    double& (*place)(Setup&);
};

constexpr std::array<PlaceField, 3> kPlaceFields{{
    {"corner-x", &setup_field::kMinX, [](Setup& setup) -> double& { return setup.stock.corner.x; }},
    {"corner-y", &setup_field::kMinY, [](Setup& setup) -> double& { return setup.stock.corner.y; }},
    {"corner-z", &setup_field::kTopZ, [](Setup& setup) -> double& { return setup.stock.corner.z; }},
}};

} // namespace

StockForm::StockForm(QWidget* parent)
    : QWidget(parent), m_shapeLabel(new QLabel(this)), m_shape(new QComboBox(this)),
      m_gridLabel(new QLabel(this)), m_grid(new GridField(QStringLiteral("spacing"), this)) {
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setColumnStretch(1, 1);
    addShapes(*layout);
    for (const PlaceField& field : kPlaceFields) {
        m_labels.push_back(new QLabel(this));
        m_boxes.push_back(lengthBox(QLatin1String(field.name), field.field->minimum, field.field->maximum));
        addRow(*layout, m_labels.back(), m_boxes.back());
    }
    addRow(*layout, m_gridLabel, m_grid);
    connect(m_grid, &GridField::edited, this, &StockForm::edited);
    retranslate();
    showFieldsOfShape();
}

void StockForm::addRow(QGridLayout& layout, QLabel* label, QWidget* editor) {
    const int row = layout.rowCount();
    label->setBuddy(editor);
    layout.addWidget(label, row, 0);
    layout.addWidget(editor, row, 1);
}

void StockForm::addShapes(QGridLayout& layout) {
    m_shape->setObjectName(QStringLiteral("stock-shape"));
    addRow(layout, m_shapeLabel, m_shape);
    for (const StockShapeRow& row : stockShapes()) {
        m_shape->addItem(QString());
        for (const StockField& field : row.fields)
            addField(layout, row, field);
    }
    connect(m_shape, &QComboBox::currentIndexChanged, this, [this] {
        showFieldsOfShape();
        emit edited();
    });
}

void StockForm::addField(QGridLayout& layout, const StockShapeRow& row, const StockField& field) {
    // A box keeps the names from before there were other shapes.
    const QString prefix = row.kind == StockKind::box ? QStringLiteral("stock")
                                                      : QStringLiteral("stock-") + QLatin1String(row.key);
    const QString name = prefix + u'-' + QLatin1String(field.name);
    ShapeField made{row.kind, &field, new QLabel(this), nullptr};
    if (std::holds_alternative<StockLength>(field.value)) {
        made.length = lengthBox(name, kSmallestSize, kLargestStockSide);
        made.editor = made.length;
    } else if (const auto* choice = std::get_if<StockChoice>(&field.value)) {
        made.choice = new QComboBox(this);
        for (std::size_t k = 0; k < choice->choices.size(); ++k)
            made.choice->addItem(QString());
        connect(made.choice, &QComboBox::currentIndexChanged, this, &StockForm::edited);
        made.editor = made.choice;
    } else {
        made.editor = fileEditor(made);
    }
    (made.file != nullptr ? made.file : made.editor)->setObjectName(name);
    addRow(layout, made.label, made.editor);
    m_fields.push_back(made);
}

QWidget* StockForm::fileEditor(ShapeField& row) {
    auto* editor = new QWidget(this);
    auto* layout = new QHBoxLayout(editor);
    layout->setContentsMargins(0, 0, 0, 0);
    row.file = new QLineEdit(editor);
    row.browse = new QToolButton(editor);
    layout->addWidget(row.file, 1);
    layout->addWidget(row.browse);
    editor->setFocusProxy(row.file);
    connect(row.file, &QLineEdit::editingFinished, this, [this, file = row.file] {
        file->setModified(false);
        emit edited();
    });
    connect(row.browse, &QToolButton::clicked, this, [this, row] { chooseFile(row); });
    return editor;
}

void StockForm::chooseFile(const ShapeField& row) {
    const QString label = coreText(row.field->label);
    const QString file = QFileDialog::getOpenFileName(
        this, label, row.file->text(),
        QStringLiteral("%1 (%2)").arg(label, QLatin1String(std::get<StockFile>(row.field->value).filter)) +
            QStringLiteral(";;") + tr("All files (*)"));
    if (file.isEmpty())
        return;
    row.file->setText(QDir::toNativeSeparators(file));
    emit edited();
}

NumberBox* StockForm::lengthBox(const QString& name, double minimum, double maximum) {
    auto* box = new NumberBox(this);
    box->setObjectName(name);
    box->setDecimals(3);
    box->setRange(minimum, maximum);
    box->setMinimumWidth(kBoxWidth); // its default would fit the largest number of the range
    box->setStepType(minimum > 0 ? QAbstractSpinBox::AdaptiveDecimalStepType
                                 : QAbstractSpinBox::DefaultStepType);
    connect(box, &QDoubleSpinBox::valueChanged, this, &StockForm::edited);
    return box;
}

void StockForm::showFieldsOfShape() {
    for (const ShapeField& row : m_fields) {
        const bool shown = row.kind == static_cast<StockKind>(m_shape->currentIndex());
        row.label->setVisible(shown);
        row.editor->setVisible(shown);
    }
}

void StockForm::show(const Setup& setup) {
    Setup copy = setup;
    for (std::size_t i = 0; i < kPlaceFields.size(); ++i) {
        m_boxes[i]->showValue(kPlaceFields[i].place(copy));
    }
    m_grid->show(setup);
    const QSignalBlocker quiet(m_shape);
    m_shape->setCurrentIndex(static_cast<int>(setup.shape.kind));
    const StockSpec spec{setup.stock, setup.shape};
    for (const ShapeField& row : m_fields) {
        if (row.length != nullptr) {
            row.length->showValue(std::get<StockLength>(row.field->value).get(spec));
        } else if (row.kind == setup.shape.kind && row.choice != nullptr) {
            const QSignalBlocker quietBox(row.choice);
            row.choice->setCurrentIndex(static_cast<int>(std::get<StockChoice>(row.field->value).get(spec)));
        } else if (row.kind == setup.shape.kind) {
            showText(*row.file, QDir::toNativeSeparators(toQString(setup.shape.file)));
        }
    }
    showFieldsOfShape();
}

void StockForm::put(Setup& setup) const {
    for (std::size_t i = 0; i < kPlaceFields.size(); ++i)
        readShown(kPlaceFields[i].place(setup), *m_boxes[i]);
    m_grid->put(setup);
}

StockSpec StockForm::spec(const Setup& setup) const {
    const StockSpec before{setup.stock, setup.shape};
    StockSpec spec{setup.stock, {}};
    spec.shape.kind = static_cast<StockKind>(m_shape->currentIndex());
    for (const ShapeField& row : m_fields) {
        if (row.kind != spec.shape.kind)
            continue;
        if (row.length != nullptr) {
            const auto& length = std::get<StockLength>(row.field->value);
            double value = length.get(before);
            readShown(value, *row.length);
            length.set(spec, value);
        } else if (row.choice != nullptr) {
            std::get<StockChoice>(row.field->value)
                .set(spec, static_cast<std::size_t>(row.choice->currentIndex()));
        } else {
            spec.shape.file = toPath(QDir::fromNativeSeparators(row.file->text().trimmed()));
        }
    }
    spec.shape.body = before.shape.body;
    spec.shape.fileState = before.shape.fileState;
    if (!(spec == before)) {
        spec.shape.body.reset();
        spec.shape.fileState = {};
    }
    return spec;
}

QString StockForm::rangeTip(const QString& help, const NumberBox& box, double defaultValue) const {
    return tr("%1\nRange: %2 to %3 mm\nDefault: %4 mm")
        .arg(help, locale().toString(box.range().minimum), locale().toString(box.range().maximum),
             locale().toString(defaultValue));
}

void StockForm::retranslateShapes() {
    m_shapeLabel->setText(tr("Shape"));
    m_shape->setAccessibleName(tr("Shape"));
    for (std::size_t k = 0; k < stockShapes().size(); ++k) {
        m_shape->setItemText(static_cast<int>(k), coreText(stockShapes()[k].label));
        m_shape->setItemData(static_cast<int>(k), coreText(stockShapes()[k].help), Qt::ToolTipRole);
    }
    for (const ShapeField& row : m_fields) {
        const QString label = coreText(row.field->label);
        row.label->setText(label);
        if (row.length != nullptr) {
            row.length->setSuffix(tr(" mm"));
            row.length->setAccessibleName(label);
            row.length->setToolTip(rangeTip(coreText(row.field->help), *row.length,
                                            std::get<StockLength>(row.field->value).get(StockSpec())));
        } else if (row.choice != nullptr) {
            row.choice->setAccessibleName(label);
            row.choice->setToolTip(coreText(row.field->help));
            const auto choices = std::get<StockChoice>(row.field->value).choices;
            for (std::size_t k = 0; k < choices.size(); ++k)
                row.choice->setItemText(static_cast<int>(k), coreText(choices[k].label));
        } else {
            row.file->setAccessibleName(label);
            row.file->setPlaceholderText(tr("Choose a file"));
            row.file->setToolTip(coreText(row.field->help));
            row.browse->setText(QStringLiteral("…"));
            row.browse->setToolTip(tr("Choose a file"));
            row.browse->setAccessibleName(tr("Choose a file"));
        }
    }
}

void StockForm::retranslate() {
    retranslateShapes();
    Setup defaults;
    for (std::size_t i = 0; i < kPlaceFields.size(); ++i) {
        const Field& field = *kPlaceFields[i].field;
        m_labels[i]->setText(coreText(field.label));
        showFieldTexts(*m_boxes[i], field, fieldNumber(field, kPlaceFields[i].place(defaults), locale()));
    }
    m_gridLabel->setText(coreText(setup_field::kGrid.label));
}

void StockForm::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace proveout
