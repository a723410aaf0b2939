// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/findings/problems_panel.h"

#include <algorithm>
#include <utility>

#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScrollBar>
#include <QSettings>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

#include "core/nc/codes/ignored_codes.h"
#include "core/simulation/run/cutting_findings.h"
#include "core/verification/findings/check_findings.h"
#include "core/verification/findings/rule_findings.h"
#include "ui/findings/problem_columns.h"
#include "ui/findings/problems_model.h"
#include "ui/findings/problems_order.h"
#include "ui/findings/rules_dialog.h"
#include "ui/findings/waive_dialog.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/elided_label.h"
#include "ui/readout/problem_list.h"
#include "ui/readout/verdict_text.h"

namespace proveout {

namespace {

constexpr const char* kContext = "ProblemCommands";

constexpr int kFilterWidth = 220; ///< px
const QString kAcceptedKey = QStringLiteral("check/accepted");

std::set<std::string> keptAcceptance() {
    std::set<std::string> ids;
    for (const QString& id : QSettings().value(kAcceptedKey).toStringList())
        ids.insert(id.toStdString());
    return ids;
}

/// Whether it can be turned off: what the program text alone shows cannot.
bool isRule(const std::string& id) {
    const auto has = [&](const FindingRow* row) { return id == row->id; };
    const auto judges = [&](const FindingRow* row) { return has(row) && row->severity == Severity::fault; };
    return std::ranges::any_of(cutting_finding::kCuttingRows, judges) ||
           std::ranges::any_of(rule_finding::kRuleRows, has);
}

std::set<int> unknownMCodes(const Diagnostics& problems) {
    std::set<int> codes;
    for (const Diagnostic& problem : problems)
        if (const auto code = unknownMCode(problem))
            codes.insert(*code);
    return codes;
}

} // namespace

const std::array<Command<ProblemsPanel>, 3> ProblemsPanel::kCommands{{
    {"next-problem", QT_TRANSLATE_NOOP("ProblemCommands", "&Next Problem"),
     QT_TRANSLATE_NOOP("ProblemCommands", "Go to the line of the next problem"), "", "F8", Reach::window,
     [](ProblemsPanel& panel) { panel.goToNeighbour(1); }},
    {"previous-problem", QT_TRANSLATE_NOOP("ProblemCommands", "&Previous Problem"),
     QT_TRANSLATE_NOOP("ProblemCommands", "Go to the line of the previous problem"), "", "Shift+F8",
     Reach::window, [](ProblemsPanel& panel) { panel.goToNeighbour(-1); }},
    {"check-rules", QT_TRANSLATE_NOOP("ProblemCommands", "&Rules…"),
     QT_TRANSLATE_NOOP("ProblemCommands", "Choose the rules of the check, and their limits"), "", "",
     Reach::window, [](ProblemsPanel& panel) { panel.editRules(); }},
}};

ProblemsPanel::ProblemsPanel(Session& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_model(new ProblemsModel(this)),
      m_order(new ProblemsOrder(*m_model, this)), m_view(new QTreeView(this)),
      m_columns(new ProblemColumns(*m_view)), m_empty(new QLabel(this)), m_summary(new ElidedLabel(this)),
      m_filter(new QLineEdit(this)), m_commands(*this, kContext, kCommands, this) {
    build();
    for (QAction* action : m_commands.all())
        addAction(action);
    session.check().setAccepted(keptAcceptance());
    connect(m_filter, &QLineEdit::textChanged, m_order, &ProblemsOrder::setWanted);
    connect(m_view, &QTreeView::activated, this, [this](const QModelIndex& index) {
        if (const CheckFinding* problem = problemAt(index))
            goTo(*problem, m_model->isOutdated(m_order->mapToSource(index).row()));
    });
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_view, &QTreeView::customContextMenuRequested, this, &ProblemsPanel::showMenu);
    connect(&session.problems(), &ProblemsHub::changed, this, &ProblemsPanel::showProblems);
    connect(&session.check(), &CheckHub::changed, this, &ProblemsPanel::showProblems);
    connect(&session.document(), &DocumentHub::changed, this, &ProblemsPanel::showNothingFound);
    connect(&session.playback(), &PlaybackHub::tick, this, &ProblemsPanel::showNothingFound);
    retranslate();
    showProblems();
}

void ProblemsPanel::build() {
    auto* top = new QHBoxLayout;
    top->setContentsMargins(8, 2, 8, 2);
    top->addWidget(m_empty, 1);
    top->addWidget(m_summary, 1);
    top->addWidget(m_filter);
    auto* rules = new QToolButton(this);
    rules->setDefaultAction(m_commands.find("check-rules"));
    top->addWidget(rules);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(top);
    layout->addWidget(m_view, 1);
    m_empty->setAlignment(Qt::AlignCenter);
    m_empty->setWordWrap(true);
    m_empty->setObjectName(QStringLiteral("nothing-found"));
    m_empty->setForegroundRole(QPalette::PlaceholderText);
    m_summary->setObjectName(QStringLiteral("problem-summary"));
    m_filter->setObjectName(QStringLiteral("problem-filter"));
    m_filter->setClearButtonEnabled(true);
    m_filter->setMaximumWidth(kFilterWidth);
    m_view->setModel(m_order);
    m_view->setRootIsDecorated(false);
    m_view->setUniformRowHeights(true);
    m_view->setAlternatingRowColors(true);
    m_view->header()->setSortIndicator(ProblemsModel::kSeverity, Qt::DescendingOrder); // the worst first
    m_view->setSortingEnabled(true);
}

const CheckFinding* ProblemsPanel::problemAt(const QModelIndex& index) const {
    return m_model->problem(m_order->mapToSource(index).row());
}

void ProblemsPanel::showProblems() {
    const int row = m_view->currentIndex().row();
    const int scrolled = m_view->verticalScrollBar()->value();
    listProblems();
    const bool any = m_model->rowCount() > 0;
    showNothingFound();
    m_summary->setText(summary());
    m_empty->setToolTip(changeDetails());
    m_summary->setToolTip(changeDetails());
    m_view->setVisible(any);
    m_filter->setVisible(any);
    m_empty->setVisible(m_model->problems().empty());
    m_summary->setVisible(!m_model->problems().empty());
    if (row >= 0 && row < m_order->rowCount())
        m_view->setCurrentIndex(m_order->index(row, 0));
    m_columns->measure();
    m_view->doItemsLayout();                         // updates the range of the scroll bar
    m_view->verticalScrollBar()->setValue(scrolled); // keeps the rows that the user is reading in place
}

/// While a check runs, the rows of the one before stay.
void ProblemsPanel::listProblems() {
    const CheckHub& check = m_session.check();
    std::vector<CheckFinding> problems = problemList(m_session);
    if (check.report())
        return m_model->setProblems(std::move(problems), check.report()->notChecked);
    const std::vector<CheckFinding> outdated = outdatedProblems(m_session, problems);
    const bool awaited = check.progress() && check.before();
    m_model->setProblems(std::move(problems), outdated,
                         awaited ? check.before()->notChecked : std::vector<NotChecked>());
}

/// "since the last check: 1 new, 2 gone"; empty if nothing has changed.
QString ProblemsPanel::changeText() const {
    const auto change = m_session.check().change();
    if (!change || *change == CheckChange())
        return {};
    return tr("since the last check: %1 new, %2 gone")
        .arg(locale().toString(static_cast<qulonglong>(change->added)),
             locale().toString(static_cast<qulonglong>(change->gone)));
}

/// What is new and what is gone, one line each.
QString ProblemsPanel::changeDetails() const {
    const CheckHub& check = m_session.check();
    if (!check.report() || !check.before())
        return {};
    constexpr std::size_t kMostLines = 10;
    QStringList lines;
    const auto add = [&](const QString& title, const std::vector<CheckFinding>& findings) {
        for (std::size_t k = 0; k < std::min(findings.size(), kMostLines); ++k)
            lines << title.arg(placedSentence(findings[k], locale()));
    };
    add(tr("New: %1"), missingFrom(*check.before(), *check.report()));
    add(tr("Gone: %1"), missingFrom(*check.report(), *check.before()));
    return lines.join(u'\n');
}

/// "Machining fault: 2 · Warning: 1 · Not checked: 3"
QString ProblemsPanel::summary() const {
    QStringList parts;
    const auto add = [&](const QString& what, std::ptrdiff_t count) {
        if (count > 0)
            parts << QStringLiteral("%1: %2").arg(what, locale().toString(static_cast<qlonglong>(count)));
    };
    for (const Severity severity : {Severity::fault, Severity::error, Severity::warning, Severity::note})
        add(severityName(severity), std::ranges::count_if(m_model->problems(), [&](const CheckFinding& one) {
                return one.diagnostic.severity == severity && !one.waived;
            }));
    add(tr("Waived"), std::ranges::count_if(m_model->problems(),
                                            [](const CheckFinding& one) { return one.waived.has_value(); }));
    add(tr("Not checked"), std::ranges::count(m_model->notChecked(), false, &NotChecked::accepted));
    if (const QString change = changeText(); !change.isEmpty())
        parts << change;
    if (m_session.check().progress())
        parts.prepend(tr("Checking…"));
    return parts.join(QStringLiteral(" · "));
}

/// The absence of problems means something only for the part that was checked.
QString ProblemsPanel::nothingFound() const {
    const auto& program = m_session.program().current();
    if (!m_session.document().isOpen())
        return tr("Open a program to see its problems.");
    if (!program || m_session.program().isReading())
        return tr("Reading the program; no problems so far.");
    if (m_session.check().report()) {
        const QString change = changeText();
        return change.isEmpty() ? tr("No problems found.") : tr("No problems found (%1).").arg(change);
    }
    if (m_session.check().progress())
        return tr("Checking the program; no problems so far.");
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

void ProblemsPanel::goTo(const CheckFinding& problem, bool outdated) {
    if (!ProblemsHub::isInText(problem.diagnostic))
        return;
    const auto line = static_cast<std::uint32_t>(problem.diagnostic.where.line);
    if (outdated) { // its blocks may be others now
        emit m_session.navigation().lineRequested(line, problem.diagnostic.where.column);
        return;
    }
    if (const auto contact = m_session.contact().show(problem)) {
        emit m_session.navigation().lineRequested(*contact, 1);
        return;
    }
    emit m_session.navigation().lineRequested(line, problem.diagnostic.where.column);
    if (problem.block > 0)
        m_session.playback().seek(problem.block);
    else
        m_session.playback().seekToLine(line);
}

/// The context menu for the row at a position of the list.
void ProblemsPanel::showMenu(const QPoint& position) {
    const QModelIndex index = m_view->indexAt(position);
    if (!index.isValid())
        return;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (const CheckFinding* problem = problemAt(index))
        addProblemActions(*menu, *problem, m_model->isOutdated(m_order->mapToSource(index).row()));
    else
        addAcceptAction(*menu, *m_model->notChecked(m_order->mapToSource(index).row()));
    menu->popup(m_view->viewport()->mapToGlobal(position));
}

void ProblemsPanel::addProblemActions(QMenu& menu, const CheckFinding& problem, bool outdated) {
    const Diagnostic& diagnostic = problem.diagnostic;
    if (ProblemsHub::isInText(diagnostic))
        menu.addAction(tr("Go to Line"), this, [this, problem, outdated] { goTo(problem, outdated); });
    menu.addAction(tr("Copy"), this, [text = sentence(diagnostic) + u' ' + hint(diagnostic)] {
        QGuiApplication::clipboard()->setText(text);
    });
    const auto& report = m_session.check().report();
    if (const CheckFinding* finding = report ? findingOf(*report, diagnostic) : nullptr)
        addJudgementActions(menu, *finding);
    if (const auto code = unknownMCode(diagnostic)) {
        QAction* ignore = menu.addAction(tr("Ignore M%1: It Moves No Axis").arg(*code), this,
                                         [this, code] { ignoreMCodes({*code}); });
        ignore->setObjectName(QStringLiteral("ignore-m-code"));
        QAction* all = menu.addAction(tr("Ignore All Unknown M Codes of This Program"), this,
                                      [this] { ignoreMCodes(unknownMCodes(m_session.problems().all())); });
        all->setObjectName(QStringLiteral("ignore-all-m-codes"));
        all->setEnabled(unknownMCodes(m_session.problems().all()).size() > 1);
    }
}

/// For a finding of the check.
void ProblemsPanel::addJudgementActions(QMenu& menu, const CheckFinding& finding) {
    menu.addSeparator();
    if (hasIdOf(finding.diagnostic, check_finding::kWaiverUnused)) {
        QAction* remove = menu.addAction(tr("Remove the Waiver"), this,
                                         [this, unused = finding.diagnostic] { removeUnused(unused); });
        remove->setObjectName(QStringLiteral("remove-waiver"));
        return;
    }
    if (finding.waived) {
        QAction* back = menu.addAction(tr("Withdraw the Waiver"), this,
                                       [this, waiver = *finding.waived] { withdraw(waiver); });
        back->setObjectName(QStringLiteral("withdraw-waiver"));
    } else if (finding.diagnostic.severity != Severity::note) {
        QAction* waiver = menu.addAction(tr("Waive…"), this, [this, finding] { waive(finding); });
        waiver->setObjectName(QStringLiteral("waive"));
    }
    const std::string rule = finding.diagnostic.id;
    if (!isRule(rule))
        return;
    QAction* off = menu.addAction(tr("Turn This Rule Off in the Job"), this, [this, rule] { turnOff(rule); });
    off->setObjectName(QStringLiteral("turn-off"));
    if (finding.tool > 0) {
        QAction* ofTool = menu.addAction(tr("Turn It Off for T%1").arg(finding.tool), this,
                                         [this, id = ruleForTool(rule, finding.tool)] { turnOff(id); });
        ofTool->setObjectName(QStringLiteral("turn-off-for-tool"));
    }
}

void ProblemsPanel::waive(const CheckFinding& finding) {
    WaiveDialog dialog(sentence(finding.diagnostic), this);
    if (dialog.exec() != QDialog::Accepted)
        return;
    // The program may have changed while the dialog was open.
    const auto& report = m_session.check().report();
    const CheckFinding* now = report ? findingOf(*report, finding.diagnostic) : nullptr;
    if (now == nullptr)
        return;
    CheckRules rules = m_session.job().check();
    rules.waivers.push_back(report->waiverOf(*now, dialog.reason(), dialog.owner()));
    m_session.job().asOneStep([&] { m_session.job().setCheck(rules); });
}

void ProblemsPanel::withdraw(const Waiver& waiver) {
    CheckRules rules = m_session.job().check();
    std::erase(rules.waivers, waiver);
    m_session.job().asOneStep([&] { m_session.job().setCheck(rules); });
}

/// The first arguments of the finding name it.
void ProblemsPanel::removeUnused(const Diagnostic& unused) {
    CheckRules rules = m_session.job().check();
    std::erase_if(rules.waivers, [&](const Waiver& waiver) {
        const std::array<Argument, 3> named{waiver.finding, waiver.owner, waiver.reason};
        return unused.arguments.size() >= named.size() &&
               std::equal(named.begin(), named.end(), unused.arguments.begin());
    });
    m_session.job().asOneStep([&] { m_session.job().setCheck(rules); });
}

void ProblemsPanel::turnOff(const std::string& rule) {
    CheckRules rules = m_session.job().check();
    rules.off.insert({rule, {}});
    m_session.job().asOneStep([&] { m_session.job().setCheck(rules); });
}

void ProblemsPanel::editRules() {
    RulesDialog dialog(m_session.job().check(), this);
    if (dialog.exec() == QDialog::Accepted)
        m_session.job().asOneStep([&] { m_session.job().setCheck(dialog.rules()); });
}

void ProblemsPanel::addAcceptAction(QMenu& menu, const NotChecked& entry) {
    QAction* action = menu.addAction(tr("Accept Without a Check, for All Programs"));
    action->setObjectName(QStringLiteral("accept-unchecked"));
    action->setCheckable(true);
    action->setChecked(entry.accepted);
    connect(action, &QAction::toggled, this, [this, id = entry.row->id](bool on) { accept(id, on); });
}

void ProblemsPanel::accept(const char* id, bool accepted) {
    std::set<std::string> ids = m_session.check().accepted();
    if (accepted)
        ids.insert(id);
    else
        ids.erase(id);
    QStringList kept;
    for (const std::string& each : ids)
        kept << QString::fromStdString(each);
    QSettings().setValue(kAcceptedKey, kept);
    m_session.check().setAccepted(std::move(ids));
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
    const int count = m_order->rowCount();
    int row = m_view->currentIndex().row();
    if (row < 0 && direction < 0)
        row = count;
    for (int tried = 0; tried < count; ++tried) {
        row = (row + direction + count) % count;
        const QModelIndex index = m_order->index(row, 0);
        if (const CheckFinding* problem = problemAt(index)) {
            m_view->setCurrentIndex(index);
            return goTo(*problem, m_model->isOutdated(m_order->mapToSource(index).row()));
        }
    }
}

void ProblemsPanel::retranslate() {
    m_commands.retranslate();
    m_view->setAccessibleName(tr("Problems"));
    m_filter->setPlaceholderText(tr("Filter"));
    m_filter->setAccessibleName(tr("Filter the problems"));
    m_filter->setToolTip(tr("Show only the rows that contain this text"));
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
