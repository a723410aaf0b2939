// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <QAbstractTableModel>

#include "core/verification/part/part_comparison.h"

namespace proveout {

/// One row per island of a comparison. UI thread.
class IslandsModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { kKind, kDepth, kArea, kVolume, kX, kY, kZ, kLine, kTool, kColumnCount };
    /// The value by which a cell is sorted.
    static constexpr int kSortRole = Qt::UserRole;

    using QAbstractTableModel::QAbstractTableModel;
    /// Null: no rows.
    void setComparison(std::shared_ptr<const PartComparison> comparison);
    [[nodiscard]] const ComparedIsland& island(int row) const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] static double number(const ComparedIsland& island, int column);
    [[nodiscard]] static QString text(const ComparedIsland& island, int column);

    std::shared_ptr<const PartComparison> m_comparison;
};

} // namespace proveout
