// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/findings/problems_order.h"

#include "ui/findings/problems_model.h"

namespace proveout {

ProblemsOrder::ProblemsOrder(ProblemsModel& model, QObject* parent)
    : QSortFilterProxyModel(parent), m_model(model) {
    setSortRole(ProblemsModel::kSortRole);
    setSortLocaleAware(true);
    setSourceModel(&model);
}

void ProblemsOrder::setWanted(const QString& text) {
    m_wanted = text.trimmed();
    invalidateFilter();
}

bool ProblemsOrder::lessThan(const QModelIndex& left, const QModelIndex& right) const {
    const bool leftLast = m_model.notChecked(left.row()) != nullptr;
    const bool rightLast = m_model.notChecked(right.row()) != nullptr;
    if (leftLast != rightLast) // in the other order it is asked for (right, left)
        return sortOrder() == Qt::AscendingOrder ? rightLast : leftLast;
    if (leftLast)
        return false;
    if (left.column() == ProblemsModel::kSeverity && left.data(sortRole()) == right.data(sortRole())) {
        const int leftLine = m_model.problem(left.row())->diagnostic.where.line;
        const int rightLine = m_model.problem(right.row())->diagnostic.where.line;
        return sortOrder() == Qt::AscendingOrder ? leftLine < rightLine : leftLine > rightLine;
    }
    return QSortFilterProxyModel::lessThan(left, right);
}

bool ProblemsOrder::filterAcceptsRow(int row, const QModelIndex& parent) const {
    if (m_wanted.isEmpty())
        return true;
    for (int column = 0; column < ProblemsModel::kColumnCount; ++column)
        if (m_model.index(row, column, parent).data().toString().contains(m_wanted, Qt::CaseInsensitive))
            return true;
    return false;
}

} // namespace proveout
