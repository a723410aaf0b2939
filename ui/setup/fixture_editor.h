// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <QWidget>

#include "core/cutting/fixtures/fixture.h"
#include "core/zmap/stock.h"

class QLabel;
class QLineEdit;
class QMenu;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace proveout {

class DescribedForm;

/// The fixtures by name: a list, and the form of the selected one. Thread: UI.
class FixtureEditor final : public QWidget {
    Q_OBJECT

public:
    explicit FixtureEditor(QWidget* parent = nullptr);
    [[nodiscard]] const Fixtures& fixtures() const { return m_fixtures; }
    /// Shows other fixtures; emits nothing. New ones are placed at the stock.
    void show(const Fixtures& fixtures, const StockBox& stock);
    /// Discards unfinished or invalid text, because it belongs to the previous document.
    void dropText();
    /// Adds the mesh of an STL file.
    void addMesh(const QString& file);

signals:
    void edited();

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    QMenu* makeAddMenu();
    /// Adds it as `name`, or with a number if that is in use; selects it.
    void add(const QString& name, const Fixture& fixture);
    void addBox();
    void addCylinder();
    void askForMesh();
    void askForVice();
    void askForStepClamp();
    void duplicateSelected();
    void removeSelected();
    void rename();
    void applyForm();
    void select();
    void fillList(const std::string& selected);
    void showFixture(QTreeWidgetItem& item, const Fixture& fixture) const;
    [[nodiscard]] QString sizeOf(const Fixture& fixture) const;
    [[nodiscard]] QString problemOf(const Fixture& fixture) const;
    void showProblem(const QString& problem);
    void retranslate();
    /// Empty: none.
    [[nodiscard]] std::string selectedName() const;

    Fixtures m_fixtures;
    StockBox m_stock;
    QTreeWidget* m_list;
    QPushButton* m_add;
    QMenu* m_menu;
    QPushButton* m_duplicate;
    QPushButton* m_remove;
    QWidget* m_details;
    QLabel* m_nameLabel;
    QLineEdit* m_name;
    DescribedForm* m_form;
    QLabel* m_problem;
};

} // namespace proveout
