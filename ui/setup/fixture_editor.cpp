// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/setup/fixture_editor.h"

#include <array>
#include <utility>

#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "core/cutting/fixtures/fixture_surface.h"
#include "core/cutting/fixtures/fixture_templates.h"
#include "core/formats/fixture_file.h"
#include "ui/document/file_paths.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/panel_layout.h"
#include "ui/look/typed_text.h"
#include "ui/setup/described_form.h"
#include "ui/setup/fixture_dialog.h"

namespace proveout {

namespace {

constexpr int kRowsShown = 4;
constexpr double kNewSize = 20; ///< mm
constexpr std::array kMenu{
    QT_TRANSLATE_NOOP("FixtureEditor", "Box"), QT_TRANSLATE_NOOP("FixtureEditor", "Cylinder"),
    QT_TRANSLATE_NOOP("FixtureEditor", "Mesh (STL)…"), QT_TRANSLATE_NOOP("FixtureEditor", "Vice…"),
    QT_TRANSLATE_NOOP("FixtureEditor", "Step Clamp…")};
constexpr std::array kMenuNames{"fixture-box", "fixture-cylinder", "fixture-mesh", "fixture-vice",
                                "fixture-step-clamp"};

/// The name, or the first free one of "name 2", "name 3", …
std::string freeName(const Fixtures& fixtures, const std::string& name) {
    std::string free = name;
    for (int number = 2; fixtures.contains(free); ++number)
        free = name + ' ' + std::to_string(number);
    return free;
}

} // namespace

FixtureEditor::FixtureEditor(QWidget* parent)
    : QWidget(parent), m_list(new QTreeWidget(this)), m_add(new QPushButton(this)), m_menu(makeAddMenu()),
      m_duplicate(new QPushButton(this)), m_remove(new QPushButton(this)), m_details(new QWidget(this)),
      m_nameLabel(new QLabel(m_details)), m_name(new QLineEdit(m_details)),
      m_form(new DescribedForm(QStringLiteral("fixture-"), m_details)), m_problem(wrappedLabel(this)) {
    build();
    connect(m_list, &QTreeWidget::currentItemChanged, this, &FixtureEditor::select);
    connect(m_duplicate, &QPushButton::clicked, this, &FixtureEditor::duplicateSelected);
    connect(m_remove, &QPushButton::clicked, this, &FixtureEditor::removeSelected);
    connect(m_name, &QLineEdit::editingFinished, this, &FixtureEditor::rename);
    connect(m_form, &DescribedForm::edited, this, &FixtureEditor::applyForm);
    retranslate();
    fillList({});
}

void FixtureEditor::build() {
    m_list->setObjectName(QStringLiteral("fixture-list"));
    m_list->setRootIsDecorated(false);
    m_list->setColumnCount(2);
    m_list->header()->setSectionResizeMode(QHeaderView::Stretch);
    m_list->setFixedHeight(m_list->header()->sizeHint().height() + kRowsShown * (fontMetrics().height() + 6));
    m_add->setObjectName(QStringLiteral("fixture-add"));
    m_add->setMenu(m_menu);
    m_duplicate->setObjectName(QStringLiteral("fixture-duplicate"));
    m_remove->setObjectName(QStringLiteral("fixture-remove"));
    m_name->setObjectName(QStringLiteral("name-of-fixture"));
    m_nameLabel->setBuddy(m_name);
    m_problem->setObjectName(QStringLiteral("fixture-problem"));
    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {m_add, m_duplicate, m_remove})
        buttons->addWidget(button);
    buttons->addStretch(1);
    auto* name = new QHBoxLayout;
    name->addWidget(m_nameLabel);
    name->addWidget(m_name, 1);
    auto* details = new QVBoxLayout(m_details);
    details->setContentsMargins(0, 0, 0, 0);
    details->addLayout(name);
    details->addWidget(m_form);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_list);
    layout->addLayout(buttons);
    layout->addWidget(m_details);
    layout->addWidget(m_problem);
}

QMenu* FixtureEditor::makeAddMenu() {
    auto* menu = new QMenu(this);
    constexpr std::array<void (FixtureEditor::*)(), kMenu.size()> kRun{
        &FixtureEditor::addBox, &FixtureEditor::addCylinder, &FixtureEditor::askForMesh,
        &FixtureEditor::askForVice, &FixtureEditor::askForStepClamp};
    for (std::size_t row = 0; row < kMenu.size(); ++row) {
        QAction* action = menu->addAction(QString(), this, kRun[row]);
        action->setObjectName(QLatin1String(kMenuNames[row]));
    }
    return menu;
}

void FixtureEditor::show(const Fixtures& fixtures, const StockBox& stock) {
    m_stock = stock;
    if (fixtures == m_fixtures)
        return;
    m_fixtures = fixtures;
    fillList(selectedName());
}

void FixtureEditor::dropText() {
    m_name->setModified(false);
    select();
}

std::string FixtureEditor::selectedName() const {
    const QTreeWidgetItem* item = m_list->currentItem();
    return item == nullptr ? std::string() : item->text(0).toStdString();
}

void FixtureEditor::add(const QString& name, const Fixture& fixture) {
    const std::string free = freeName(m_fixtures, name.toStdString());
    m_fixtures.emplace(free, fixture);
    fillList(free);
}

void FixtureEditor::addBox() {
    add(tr("Box"), FixtureBox{.x = m_stock.corner.x - kNewSize,
                              .y = m_stock.corner.y,
                              .z = m_stock.floorZ(),
                              .w = kNewSize,
                              .d = kNewSize,
                              .h = m_stock.height});
    emit edited();
}

void FixtureEditor::addCylinder() {
    add(tr("Cylinder"), FixtureCylinder{.x = m_stock.corner.x - kNewSize / 2,
                                        .y = m_stock.corner.y + kNewSize / 2,
                                        .z = m_stock.floorZ(),
                                        .d = kNewSize,
                                        .h = m_stock.height});
    emit edited();
}

void FixtureEditor::askForMesh() {
    const QString file = QFileDialog::getOpenFileName(this, tr("Mesh of a Fixture"), QString(),
                                                      tr("Mesh (%1)").arg(QStringLiteral("*.stl")));
    if (!file.isEmpty())
        addMesh(file);
}

/// Its zero is that of the program: many are exported together with the part.
void FixtureEditor::addMesh(const QString& file) {
    FixtureMesh mesh{.file = toPath(file)};
    readFixtureFile(mesh);
    add(QFileInfo(file).completeBaseName(), mesh);
    emit edited();
}

void FixtureEditor::askForVice() {
    proveout::askForVice(*this, viceFor(m_stock), [this](const Vice& vice) {
        const ViceParts parts = partsOf(vice, m_stock);
        add(tr("Bed"), parts.bed);
        add(tr("Moving jaw"), parts.movingJaw);
        add(tr("Fixed jaw"), parts.fixedJaw);
        emit edited();
    });
}

void FixtureEditor::askForStepClamp() {
    proveout::askForStepClamp(*this, stepClampFor(m_stock), [this](const StepClamp& clamp) {
        const StepClampParts parts = partsOf(clamp, m_stock);
        add(tr("Bolt"), parts.bolt);
        add(tr("Clamp"), parts.bar);
        emit edited();
    });
}

void FixtureEditor::duplicateSelected() {
    const auto found = m_fixtures.find(selectedName());
    if (found == m_fixtures.end())
        return;
    add(QString::fromStdString(found->first), Fixture(found->second));
    emit edited();
}

void FixtureEditor::removeSelected() {
    const auto found = m_fixtures.find(selectedName());
    if (found == m_fixtures.end())
        return;
    const auto next = m_fixtures.erase(found);
    fillList(next == m_fixtures.end() ? std::string() : next->first);
    emit edited();
}

/// A name that is refused stays in its field, with the reason below.
void FixtureEditor::rename() {
    const std::string before = selectedName();
    const std::string name = m_name->text().trimmed().toStdString();
    m_name->setModified(false);
    showProblem({});
    if (name == before || before.empty())
        return;
    if (const auto named = parseFixtureOption(name + '=' + fixtureText(m_fixtures.at(before))); !named)
        return showProblem(sentence(named.error().front()));
    if (m_fixtures.contains(name))
        return showProblem(tr("There is already a fixture \"%1\".").arg(QString::fromStdString(name)));
    auto fixture = m_fixtures.extract(before);
    fixture.key() = name;
    m_fixtures.insert(std::move(fixture));
    fillList(name);
    emit edited();
}

void FixtureEditor::applyForm() {
    const auto found = m_fixtures.find(selectedName());
    if (found == m_fixtures.end())
        return;
    std::visit([this](auto& shape) { m_form->put(shape); }, found->second);
    showFixture(*m_list->currentItem(), found->second);
    emit edited();
}

void FixtureEditor::fillList(const std::string& selected) {
    {
        const QSignalBlocker quiet(m_list);
        m_list->clear();
        for (const auto& [name, fixture] : m_fixtures) {
            auto* item = new QTreeWidgetItem(m_list, {QString::fromStdString(name)});
            showFixture(*item, fixture);
            if (name == selected)
                m_list->setCurrentItem(item);
        }
        if (m_list->currentItem() == nullptr && m_list->topLevelItemCount() > 0)
            m_list->setCurrentItem(m_list->topLevelItem(0));
    }
    m_list->setVisible(!m_fixtures.empty());
    select();
}

/// "20 × 30 × 40", "⌀ 20 × 40"
QString FixtureEditor::sizeOf(const Fixture& fixture) const {
    const auto number = [this](double value) { return locale().toString(value, 'g', 6); };
    if (const auto* cylinder = std::get_if<FixtureCylinder>(&fixture))
        return QStringLiteral("⌀ %1 × %2").arg(number(cylinder->d), number(cylinder->h));
    const Box3 bounds = boundsOf(fixture);
    const Vec3 size = bounds.hi - bounds.lo;
    return QStringLiteral("%1 × %2 × %3").arg(number(size.x), number(size.y), number(size.z));
}

void FixtureEditor::showFixture(QTreeWidgetItem& item, const Fixture& fixture) const {
    const auto* mesh = std::get_if<FixtureMesh>(&fixture);
    const bool unread = mesh != nullptr && !isUsable(*mesh);
    item.setText(1, unread ? tr("Not read") : sizeOf(fixture));
    item.setToolTip(0, item.text(0));
    item.setToolTip(1, mesh == nullptr ? item.text(1) : QString::fromStdString(mesh->file.string()));
}

/// What is wrong with the file of a mesh.
QString FixtureEditor::problemOf(const Fixture& fixture) const {
    const auto* mesh = std::get_if<FixtureMesh>(&fixture);
    if (mesh == nullptr || !mesh->surface || mesh->surface->findings().empty())
        return {};
    const Diagnostic& first = mesh->surface->findings().front();
    return sentence(first) + u' ' + hint(first);
}

void FixtureEditor::select() {
    const auto found = m_fixtures.find(selectedName());
    const bool any = found != m_fixtures.end();
    m_details->setVisible(any);
    m_duplicate->setEnabled(any);
    m_remove->setEnabled(any);
    showProblem({});
    if (!any)
        return;
    showProblem(problemOf(found->second));
    showText(*m_name, QString::fromStdString(found->first));
    std::visit([this](const auto& shape) { m_form->show(shape); }, found->second);
}

void FixtureEditor::showProblem(const QString& problem) {
    m_problem->setText(problem);
    m_problem->setVisible(!problem.isEmpty());
}

void FixtureEditor::retranslate() {
    m_list->setHeaderLabels({tr("Name"), tr("Size")});
    m_list->setAccessibleName(tr("Fixtures"));
    m_add->setText(tr("Add"));
    m_add->setToolTip(tr("Add a fixture at the stock"));
    m_duplicate->setText(tr("Copy"));
    m_duplicate->setToolTip(tr("Add a copy of the selected fixture"));
    m_remove->setText(tr("Remove"));
    m_remove->setToolTip(tr("Remove the selected fixture"));
    m_nameLabel->setText(tr("Name"));
    m_name->setAccessibleName(tr("Name of the fixture"));
    m_name->setToolTip(tr("Findings name the fixture like this"));
    const QList<QAction*> actions = m_menu->actions();
    for (std::size_t row = 0; row < kMenu.size(); ++row)
        actions[static_cast<qsizetype>(row)]->setText(tr(kMenu[row]));
}

void FixtureEditor::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace proveout
