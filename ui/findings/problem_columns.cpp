// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/findings/problem_columns.h"

#include <algorithm>
#include <cstddef>

#include <QEvent>
#include <QHeaderView>
#include <QTreeView>

namespace proveout {

namespace {

/// QTreeView makes sizeHintForColumn() protected, while its base class has it public.
int contentWidth(const QAbstractItemView& view, int column) {
    return view.sizeHintForColumn(column);
}

} // namespace

ProblemColumns::ProblemColumns(QTreeView& view) : QObject(&view), m_view(view) {
    view.header()->setStretchLastSection(false);
    view.header()->setSectionResizeMode(QHeaderView::Fixed);
    view.setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    view.viewport()->installEventFilter(this);
}

void ProblemColumns::measure() {
    for (int column = 0; column < ProblemsModel::kColumnCount; ++column)
        m_wanted[static_cast<std::size_t>(column)] =
            std::max(contentWidth(m_view, column), m_view.header()->sectionSizeHint(column));
    share();
}

void ProblemColumns::share() {
    QHeaderView& header = *m_view.header();
    int rest = m_view.viewport()->width();
    for (const int column : {ProblemsModel::kSeverity, ProblemsModel::kLine, ProblemsModel::kSentence,
                             ProblemsModel::kTool, ProblemsModel::kSize, ProblemsModel::kCount}) {
        header.resizeSection(column, m_wanted[static_cast<std::size_t>(column)]);
        rest -= m_wanted[static_cast<std::size_t>(column)];
    }
    const int id = m_wanted[ProblemsModel::kId];
    const bool roomForId = rest >= m_wanted[ProblemsModel::kHint] + id;
    header.setSectionHidden(ProblemsModel::kId, !roomForId);
    if (roomForId) {
        header.resizeSection(ProblemsModel::kId, id);
        rest -= id;
    }
    header.resizeSection(ProblemsModel::kHint, std::max(header.sectionSizeHint(ProblemsModel::kHint), rest));
}

bool ProblemColumns::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize)
        share();
    else if (event->type() == QEvent::FontChange)
        measure();
    return QObject::eventFilter(watched, event);
}

} // namespace proveout
