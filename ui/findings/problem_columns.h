// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <QObject>

#include "ui/findings/problems_model.h"

class QTreeView;

namespace proveout {

/// Distributes the width of the problem list among its columns: the sentence comes first and is never elided;
/// the hint gets the remaining width and is elided; the id is shown only if all columns fit.
class ProblemColumns final : public QObject {
    Q_OBJECT

public:
    explicit ProblemColumns(QTreeView& view);
    /// Call it after a change of the rows or of their texts.
    void measure();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void share();

    QTreeView& m_view;
    std::array<int, ProblemsModel::kColumnCount> m_wanted{}; ///< px
};

} // namespace proveout
