// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <QObject>

#include "ui/findings/problems_model.h"

class QTreeView;

namespace proveout {

/// Shares the width of the list of problems among its columns: the sentence first, whole; what to do gets the
/// rest, and is elided; the id is there where all of them have room.
class ProblemColumns final : public QObject {
    Q_OBJECT

public:
    explicit ProblemColumns(QTreeView& view);
    /// After a change of the rows or of their texts.
    void measure();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void share();

    QTreeView& m_view;
    std::array<int, ProblemsModel::kColumnCount> m_wanted{}; ///< px
};

} // namespace proveout
