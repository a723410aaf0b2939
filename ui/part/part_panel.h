// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/session/session.h"

class QLabel;
class QModelIndex;
class QSortFilterProxyModel;
class QToolButton;
class QTreeView;

namespace proveout {

class DeviationChart;
class ElidedLabel;
class IslandsModel;
class PartForm;

/// Whether the part is right: the design part with its place and tolerance, and what the check of the whole
/// program found: the islands out of tolerance and the histogram. UI thread.
class PartPanel final : public QWidget {
    Q_OBJECT

public:
    explicit PartPanel(Session& session, QWidget* parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override;

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void showResult();
    [[nodiscard]] QString state() const;
    void goTo(const QModelIndex& index);
    void saveCsv();
    void retranslate();

    Session& m_session;
    PartForm* m_form;
    ElidedLabel* m_result;
    QToolButton* m_csv;
    IslandsModel* m_model;
    QSortFilterProxyModel* m_order;
    QTreeView* m_view;
    QLabel* m_empty;
    DeviationChart* m_chart;
};

} // namespace proveout
