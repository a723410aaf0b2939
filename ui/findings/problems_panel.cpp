// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/findings/problems_panel.h"

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QTreeView>
#include <QVBoxLayout>

#include "ui/findings/problems_model.h"

namespace proveout {

namespace {
constexpr const char* kContext = "ProblemCommands";
}

const std::array<Command<ProblemsPanel>, 2> ProblemsPanel::kCommands{{
    {"next-problem", QT_TRANSLATE_NOOP("ProblemCommands", "&Next Problem"),
     QT_TRANSLATE_NOOP("ProblemCommands", "Go to the line of the next problem"), "", "F8", Reach::window,
     [](ProblemsPanel& panel) { panel.goToNeighbour(1); }},
    {"previous-problem", QT_TRANSLATE_NOOP("ProblemCommands", "&Previous Problem"),
     QT_TRANSLATE_NOOP("ProblemCommands", "Go to the line of the previous problem"), "", "Shift+F8",
     Reach::window, [](ProblemsPanel& panel) { panel.goToNeighbour(-1); }},
}};

ProblemsPanel::ProblemsPanel(Session& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_model(new ProblemsModel(this)), m_view(new QTreeView(this)),
      m_empty(new QLabel(this)), m_commands(*this, kContext, kCommands, this) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_view, 1);
    layout->addWidget(m_empty, 1);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_view->setModel(m_model);
    m_view->setRootIsDecorated(false);
    m_view->setUniformRowHeights(true);
    m_view->setAlternatingRowColors(true);
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->header()->setStretchLastSection(false);
    m_view->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_view->header()->setSectionResizeMode(ProblemsModel::kSentence, QHeaderView::Stretch);
    for (QAction* action : m_commands.all())
        addAction(action);
    connect(m_view, &QTreeView::activated, this, [this](const QModelIndex& index) { goTo(index.row()); });
    connect(&session, &Session::problemsChanged, this, &ProblemsPanel::showProblems);
    retranslate();
    showProblems();
}

void ProblemsPanel::showProblems() {
    const int row = m_view->currentIndex().row();
    m_model->setProblems(m_session.problems());
    const bool any = m_model->rowCount() > 0;
    m_view->setVisible(any);
    m_empty->setVisible(!any);
    if (row >= 0 && row < m_model->rowCount())
        m_view->setCurrentIndex(m_model->index(row, 0));
}

void ProblemsPanel::goTo(int row) {
    const Diagnostic& problem = m_model->problem(row);
    if (!Session::isInText(problem))
        return;
    const auto line = static_cast<std::uint32_t>(problem.where.line);
    emit m_session.lineRequested(line, problem.where.column);
    m_session.seekToLine(line);
}

void ProblemsPanel::goToNeighbour(int direction) {
    const int count = m_model->rowCount();
    if (count == 0)
        return;
    const int present = m_view->currentIndex().row();
    const int row = present < 0 && direction < 0 ? count - 1 : (present + direction + count) % count;
    m_view->setCurrentIndex(m_model->index(row, 0));
    goTo(row);
}

void ProblemsPanel::retranslate() {
    m_commands.retranslate();
    m_view->setAccessibleName(tr("Problems"));
    m_empty->setText(tr("No problems found."));
}

void ProblemsPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        showProblems();
    }
}

} // namespace proveout
