// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/findings/problems_panel.h"

#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QLabel>
#include <QMenu>
#include <QScrollBar>
#include <QTreeView>
#include <QVBoxLayout>

#include "core/nc/codes/ignored_codes.h"
#include "ui/findings/problem_columns.h"
#include "ui/findings/problems_model.h"
#include "ui/look/diagnostic_text.h"

namespace proveout {

namespace {

constexpr const char* kContext = "ProblemCommands";

std::set<int> unknownMCodes(const Diagnostics& problems) {
    std::set<int> codes;
    for (const Diagnostic& problem : problems)
        if (const auto code = unknownMCode(problem))
            codes.insert(*code);
    return codes;
}

} // namespace

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
      m_columns(new ProblemColumns(*m_view)), m_empty(new QLabel(this)),
      m_commands(*this, kContext, kCommands, this) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_view, 1);
    layout->addWidget(m_empty, 1);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    m_empty->setObjectName(QStringLiteral("nothing-found"));
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_view->setModel(m_model);
    m_view->setRootIsDecorated(false);
    m_view->setUniformRowHeights(true);
    m_view->setAlternatingRowColors(true);
    m_view->setFrameShape(QFrame::NoFrame);
    for (QAction* action : m_commands.all())
        addAction(action);
    connect(m_view, &QTreeView::activated, this,
            [this](const QModelIndex& index) { goTo(m_model->problem(index.row())); });
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_view, &QTreeView::customContextMenuRequested, this, &ProblemsPanel::showMenu);
    connect(&session.problems(), &ProblemsHub::changed, this, &ProblemsPanel::showProblems);
    connect(&session.document(), &DocumentHub::changed, this, &ProblemsPanel::showNothingFound);
    connect(&session.playback(), &PlaybackHub::tick, this, &ProblemsPanel::showNothingFound);
    retranslate();
    showProblems();
}

void ProblemsPanel::showProblems() {
    const int row = m_view->currentIndex().row();
    const int scrolled = m_view->verticalScrollBar()->value();
    m_model->setProblems(m_session.problems().all());
    const bool any = m_model->rowCount() > 0;
    showNothingFound();
    m_view->setVisible(any);
    m_empty->setVisible(!any);
    if (row >= 0 && row < m_model->rowCount())
        m_view->setCurrentIndex(m_model->index(row, 0));
    m_columns->measure();
    m_view->doItemsLayout();                         // updates the range of the scroll bar
    m_view->verticalScrollBar()->setValue(scrolled); // keeps the rows that the user is reading in place
}

/// The absence of problems means something only for the part that was checked.
QString ProblemsPanel::nothingFound() const {
    const auto& program = m_session.program().current();
    if (!m_session.document().isOpen())
        return tr("Open a program to see its problems.");
    if (!program || m_session.program().isReading())
        return tr("Reading the program; no problems so far.");
    const FramePtr& frame = m_session.simulation().frame();
    const std::size_t simulated = frame && frame->program == program ? frame->statistics.size() : 0;
    if (simulated == 0 && program->blockCount() > 0)
        return tr("Not simulated yet; no problems in the program text.");
    if (simulated < program->blockCount())
        return tr("No problems up to block %1 of %2.")
            .arg(locale().toString(static_cast<qulonglong>(simulated)),
                 locale().toString(static_cast<qulonglong>(program->blockCount())));
    return tr("No problems found.");
}

void ProblemsPanel::showNothingFound() {
    if (const QString text = nothingFound(); text != m_empty->text())
        m_empty->setText(text);
}

void ProblemsPanel::goTo(const Diagnostic& problem) {
    if (!ProblemsHub::isInText(problem))
        return;
    const auto line = static_cast<std::uint32_t>(problem.where.line);
    emit m_session.navigation().lineRequested(line, problem.where.column);
    m_session.playback().seekToLine(line);
}

/// The context menu for the problem at a position of the list.
void ProblemsPanel::showMenu(const QPoint& position) {
    const QModelIndex index = m_view->indexAt(position);
    if (!index.isValid())
        return;
    const Diagnostic& problem = m_model->problem(index.row());
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (ProblemsHub::isInText(problem))
        menu->addAction(tr("Go to Line"), this, [this, problem] { goTo(problem); });
    menu->addAction(tr("Copy"), this, [text = sentence(problem) + u' ' + hint(problem)] {
        QGuiApplication::clipboard()->setText(text);
    });
    if (const auto code = unknownMCode(problem)) {
        QAction* ignore = menu->addAction(tr("Ignore M%1: It Moves No Axis").arg(*code), this,
                                          [this, code] { ignoreMCodes({*code}); });
        ignore->setObjectName(QStringLiteral("ignore-m-code"));
        QAction* all = menu->addAction(tr("Ignore All Unknown M Codes of This Program"), this,
                                       [this] { ignoreMCodes(unknownMCodes(m_session.problems().all())); });
        all->setObjectName(QStringLiteral("ignore-all-m-codes"));
        all->setEnabled(unknownMCodes(m_session.problems().all()).size() > 1);
    }
    menu->popup(m_view->viewport()->mapToGlobal(position));
}

void ProblemsPanel::ignoreMCodes(const std::set<int>& codes) {
    m_session.job().asOneStep([this, &codes] {
        Setup setup = m_session.job().setup();
        setup.ignoredM.insert(codes.begin(), codes.end());
        if (const auto done = m_session.job().setSetup(setup); !done)
            m_session.problems().report(done.error());
    });
}

void ProblemsPanel::goToNeighbour(int direction) {
    const int count = m_model->rowCount();
    if (count == 0)
        return;
    const int present = m_view->currentIndex().row();
    const int row = present < 0 && direction < 0 ? count - 1 : (present + direction + count) % count;
    m_view->setCurrentIndex(m_model->index(row, 0));
    goTo(m_model->problem(row));
}

void ProblemsPanel::retranslate() {
    m_commands.retranslate();
    m_view->setAccessibleName(tr("Problems"));
    showNothingFound();
}

void ProblemsPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        showProblems();
    }
}

} // namespace proveout
