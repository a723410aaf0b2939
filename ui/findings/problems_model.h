// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <QAbstractTableModel>
#include <QIcon>

#include "core/base/diagnostic.h"

namespace proveout {

/// One row per message. UI thread.
class ProblemsModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { kSeverity, kLine, kSentence, kHint, kId, kColumnCount };

    explicit ProblemsModel(QObject* parent = nullptr);
    void setProblems(const Diagnostics& problems);
    [[nodiscard]] const Diagnostic& problem(int row) const {
        return m_problems[static_cast<std::size_t>(row)];
    }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] static QString text(const Diagnostic& problem, int column);
    [[nodiscard]] static QString wholeText(const Diagnostic& problem);

    Diagnostics m_problems;
    std::array<QIcon, 4> m_icons; ///< one per severity
};

} // namespace proveout
