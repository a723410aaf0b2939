// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <QAbstractTableModel>
#include <QIcon>

#include "core/verification/check/check_report.h"

namespace proveout {

/// One row per problem, then one for each thing that was not checked. UI thread.
class ProblemsModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { kSeverity, kLine, kSentence, kTool, kSize, kCount, kHint, kId, kColumnCount };
    /// The value by which a cell is sorted.
    static constexpr int kSortRole = Qt::UserRole;

    explicit ProblemsModel(QObject* parent = nullptr);
    /// `notChecked` follow the problems.
    void setProblems(std::vector<CheckFinding> problems, std::vector<NotChecked> notChecked);
    /// The same while a check runs: these problems follow the others, and are shown in grey, as is what was
    /// not checked.
    void setProblems(std::vector<CheckFinding> problems, const std::vector<CheckFinding>& outdated,
                     std::vector<NotChecked> notChecked);
    /// Whether the row is of a check before the last change.
    [[nodiscard]] bool isOutdated(int row) const { return static_cast<std::size_t>(row) >= m_current; }
    /// Null: the row is of something that was not checked.
    [[nodiscard]] const CheckFinding* problem(int row) const;
    /// Null: the row is of a problem.
    [[nodiscard]] const NotChecked* notChecked(int row) const;
    [[nodiscard]] const std::vector<CheckFinding>& problems() const { return m_problems; }
    [[nodiscard]] const std::vector<NotChecked>& notChecked() const { return m_notChecked; }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] static QString waiverText(const Waiver& waiver);
    [[nodiscard]] static QString text(const CheckFinding& problem, int column);
    [[nodiscard]] static QString text(const NotChecked& entry, int column);
    [[nodiscard]] QIcon iconOf(int row) const;
    [[nodiscard]] static QVariant sortValue(const CheckFinding& problem, int column);
    [[nodiscard]] static QString wholeText(const CheckFinding& problem);
    [[nodiscard]] static QString wholeText(const NotChecked& entry);

    std::vector<CheckFinding> m_problems;
    std::vector<NotChecked> m_notChecked;
    std::size_t m_current = 0;    ///< so many rows, the first ones, are not outdated
    std::array<QIcon, 4> m_icons; ///< one per severity
    QIcon m_openIcon;             ///< of what was not checked
    QIcon m_acceptedIcon;
};

} // namespace proveout
