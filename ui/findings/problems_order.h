// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSortFilterProxyModel>

namespace proveout {

class ProblemsModel;

/// The rows of ProblemsModel that contain a text, sorted by a column, those of one severity by their lines;
/// what was not checked is always last.
/// UI thread.
class ProblemsOrder final : public QSortFilterProxyModel {
    Q_OBJECT

public:
    /// `model` must outlive this object.
    explicit ProblemsOrder(ProblemsModel& model, QObject* parent = nullptr);
    /// Any case; empty: all rows.
    void setWanted(const QString& text);

protected:
    [[nodiscard]] bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;
    [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    const ProblemsModel& m_model;
    QString m_wanted;
};

} // namespace proveout
