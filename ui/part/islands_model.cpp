// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/part/islands_model.h"

#include <limits>
#include <utility>

#include <QLocale>

#include "ui/part/part_text.h"

namespace proveout {

void IslandsModel::setComparison(std::shared_ptr<const PartComparison> comparison) {
    if (m_comparison == comparison)
        return;
    beginResetModel();
    m_comparison = std::move(comparison);
    endResetModel();
}

const ComparedIsland& IslandsModel::island(int row) const {
    return m_comparison->islands[static_cast<std::size_t>(row)];
}

int IslandsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !m_comparison ? 0 : static_cast<int>(m_comparison->islands.size());
}

int IslandsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : kColumnCount;
}

double IslandsModel::number(const ComparedIsland& island, int column) {
    switch (column) {
    case kDepth:
        return island.of.depthMm;
    case kArea:
        return island.of.areaMm2;
    case kVolume:
        return island.of.volumeMm3;
    case kX:
        return island.of.place.x;
    case kY:
        return island.of.place.y;
    case kZ:
        return island.of.place.z;
    case kLine:
        return island.block ? island.line : std::numeric_limits<double>::max();
    default:
        return island.block ? island.tool : -1;
    }
}

QString IslandsModel::text(const ComparedIsland& island, int column) {
    const QLocale locale;
    switch (column) {
    case kKind:
        return kindName(island.of.kind);
    case kLine:
        return island.block ? locale.toString(island.line) : causeText(island);
    case kTool:
        return island.block ? QStringLiteral("T%1").arg(island.tool) : QString();
    case kArea:
    case kVolume:
        return locale.toString(number(island, column), 'f', kSizeDecimals);
    default:
        return locale.toString(number(island, column), 'f', kLengthDecimals);
    }
}

QVariant IslandsModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid())
        return {};
    const ComparedIsland& one = island(index.row());
    if (role == Qt::DisplayRole)
        return text(one, index.column());
    if (role == kSortRole)
        return index.column() == kKind ? QVariant(kindName(one.of.kind)) : number(one, index.column());
    if (role == Qt::ToolTipRole)
        return islandText(one);
    const bool isNumber = index.column() != kKind && !(index.column() == kLine && !one.block);
    if (role == Qt::TextAlignmentRole && isNumber)
        return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
    return {};
}

QVariant IslandsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>((section == kKind ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case kKind:
        return tr("Kind");
    case kDepth:
        return tr("Depth, mm");
    case kArea:
        return tr("Area, mm²");
    case kVolume:
        return tr("Volume, mm³");
    case kX:
        return QStringLiteral("X");
    case kY:
        return QStringLiteral("Y");
    case kZ:
        return QStringLiteral("Z");
    case kLine:
        return tr("Line");
    default:
        return tr("Tool");
    }
}

} // namespace proveout
