// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/setup/setup_panel.h"

#include <new>
#include <utility>

#include <QEvent>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "core/base/memory.h"
#include "core/base/text.h"
#include "core/simulation/setup/setup_memory.h"
#include "core/verification/findings/window_findings.h"
#include "ui/document/carried_values.h"
#include "ui/document/file_paths.h"
#include "ui/files/edited_elsewhere_bar.h"
#include "ui/files/file_changed_bar.h"
#include "ui/look/diagnostic_text.h"
#include "ui/look/panel_layout.h"
#include "ui/readout/tool_actions.h"
#include "ui/setup/control_form.h"
#include "ui/setup/fixture_editor.h"
#include "ui/setup/kept_in_view.h"
#include "ui/setup/machine_form.h"
#include "ui/setup/stock_changed_bar.h"
#include "ui/setup/stock_form.h"
#include "ui/setup/tool_table_editor.h"

namespace proveout {

namespace {

constexpr int kRestMs = 250;

} // namespace

SetupPanel::SetupPanel(Session& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_programTitle(sectionLabel(this)),
      m_control(new ControlForm(session, this)), m_stockTitle(sectionLabel(this)),
      m_stock(new StockForm(this)), m_fit(new QPushButton(this)), m_memory(wrappedLabel(this)),
      m_problem(wrappedLabel(this)), m_fixturesTitle(sectionLabel(this)), m_fixtures(new FixtureEditor(this)),
      m_toolsTitle(sectionLabel(this)), m_tools(new ToolTableEditor(this)), m_missing(wrappedLabel(this)),
      m_define(new QPushButton(this)), m_machineTitle(sectionLabel(this)),
      m_machine(new MachineForm(session, this)) {
    build();
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestMs);
    connect(&m_rest, &QTimer::timeout, this, &SetupPanel::apply);
    connect(m_control, &ControlForm::edited, &m_rest, qOverload<>(&QTimer::start));
    connect(m_stock, &StockForm::edited, &m_rest, qOverload<>(&QTimer::start));
    connect(m_fixtures, &FixtureEditor::edited, &m_rest, qOverload<>(&QTimer::start));
    connect(m_tools, &ToolTableEditor::edited, &m_rest, qOverload<>(&QTimer::start));
    connect(m_fit, &QPushButton::clicked, this, &SetupPanel::fitToProgram);
    connect(m_tools, &ToolTableEditor::lineWanted, this,
            [this](std::uint32_t line) { emit m_session.navigation().lineRequested(line, 1); });
    // Queued, because the window must show the panel first: a hidden widget cannot get the focus.
    connect(&session.navigation(), &NavigationHub::toolRequested, this, &SetupPanel::showTool,
            Qt::QueuedConnection);
    connect(m_define, &QPushButton::clicked, this, [this] { assumeMissingTools(m_session); });
    connect(&session.job(), &JobHub::inputWanted, this, [this] {
        if (m_rest.isActive())
            apply();
    });
    connect(&session.job(), &JobHub::replaced, this, &SetupPanel::dropInput);
    connect(&session.job(), &JobHub::setupChanged, this, &SetupPanel::showSetup);
    connect(&session.job(), &JobHub::parametersChanged, this,
            [this] { showMemory(m_session.job().setup()); });
    connect(&session.document(), &DocumentHub::changed, this, &SetupPanel::titleTools);
    connect(&session.program(), &ProgramHub::changed, this, &SetupPanel::showMissingTools);
    connect(&session.program(), &ProgramHub::changed, this, &SetupPanel::showControl);
    retranslate();
    dropInput();
}

void SetupPanel::build() {
    auto* content = new QWidget;
    auto* layout = new QVBoxLayout(content);
    layout->addWidget(new EditedElsewhereBar(m_session, FilePart::job, content));
    layout->addWidget(new FileChangedBar(m_session, FilePart::job, content));
    layout->addWidget(new StockChangedBar(m_session, content));
    layout->addWidget(m_programTitle);
    layout->addWidget(m_control);
    layout->addSpacing(10);
    for (QWidget* widget :
         {static_cast<QWidget*>(m_stockTitle), static_cast<QWidget*>(m_stock), static_cast<QWidget*>(m_fit),
          static_cast<QWidget*>(m_memory), static_cast<QWidget*>(m_problem)})
        layout->addWidget(widget);
    layout->addSpacing(10);
    layout->addWidget(m_fixturesTitle);
    layout->addWidget(m_fixtures);
    layout->addSpacing(10);
    for (QWidget* widget : {static_cast<QWidget*>(m_toolsTitle), static_cast<QWidget*>(m_missing),
                            static_cast<QWidget*>(m_define), static_cast<QWidget*>(m_tools)})
        layout->addWidget(widget);
    layout->addSpacing(10);
    layout->addWidget(m_machineTitle);
    layout->addWidget(m_machine);
    layout->addStretch(1);
    fillScrolled(*this, content);
    m_toolInView = new KeptInView(*findChild<QScrollArea*>(), *m_tools);
    m_problem->hide();
}

/// The document has changed, so edits of the previous one are void.
void SetupPanel::dropInput() {
    m_rest.stop();
    m_making.cancel();
    m_shown = m_session.job().setup();
    fill(m_shown);
    m_control->dropText();
    m_fixtures->dropText();
}

/// The setup can change at any time, because the stock is fitted and tools are found in comments. Changes by
/// the user that are not applied yet stay in the form.
void SetupPanel::showSetup() {
    Setup form = edited(m_shown);
    if (m_rest.isActive() || m_session.job().setup().shape == m_shown.shape) {
        const StockSpec spec = m_stock->spec(form);
        form.stock = spec.box;
        form.shape = spec.shape;
    } else { // a shape whose file is still being read is void, e.g. after undo
        m_making.cancel();
    }
    const Setup held = carried(m_session.job().setup(), m_shown, form);
    m_shown = m_session.job().setup();
    fill(held);
}

void SetupPanel::fill(const Setup& setup) {
    m_stock->show(setup);
    m_fixtures->show(setup.fixtures, setup.stock);
    m_tools->show(setup.tools);
    showStockProblem();
    m_control->show(setup);
    showMemory(m_session.job().setup());
    showMissingTools();
}

void SetupPanel::showMissingTools() {
    const std::vector<int> missing = missingTools(m_session);
    m_missing->setText(tr("Tools missing from the table: %1").arg(toolList(missing)));
    m_missing->setVisible(!missing.empty());
    m_define->setVisible(!missing.empty());
    const bool box = m_session.job().setup().shape.kind == StockKind::box;
    m_fit->setEnabled(m_session.program().blockCount() > 0 && box);
}

void SetupPanel::showControl() {
    m_control->showProgram(edited(m_session.job().setup()));
}

void SetupPanel::showStockProblem() {
    const Result<void> whole = checkShape(m_session.job().setup().shape);
    m_problem->setVisible(!whole);
    if (!whole)
        showProblem(whole.error());
}

void SetupPanel::showMemory(const Setup& setup) {
    const Result<Grid> grid = makeGrid(setup.stock, setup.spacing);
    if (!grid) {
        m_memory->clear();
        return;
    }
    const MemoryForecast memory = memoryForecast(setup, *grid, m_session.job().parameters(), true);
    m_memory->setText(tr("%1 × %2 points, spacing %3 × %4 mm; needs about %5, at most %6")
                          .arg(locale().toString(grid->nx), locale().toString(grid->ny),
                               locale().toString(grid->hx, 'g', 5), locale().toString(grid->hy, 'g', 5),
                               figuresText(readableBytes(memory.expected)),
                               figuresText(readableBytes(memory.most))));
}

/// `setup` with the values of the form, except shape and size of the stock, whose body may have to be
/// created.
Setup SetupPanel::edited(Setup setup) const {
    setup.fixtures = m_fixtures->fixtures();
    setup.tools = m_tools->tools();
    m_stock->put(setup);
    m_control->put(setup);
    return setup;
}

void SetupPanel::apply() {
    m_rest.stop();
    m_making.cancel();
    applyStock(edited(m_session.job().setup()));
}

/// Creates the body again if its description has changed; immediately if no file is needed.
void SetupPanel::applyStock(Setup setup) {
    const StockSpec spec = m_stock->spec(setup);
    const StockShape& before = setup.shape;
    const bool box = spec.shape.kind == StockKind::box;
    const bool another = spec.shape.kind != before.kind || spec.shape.file != before.file;
    if (box || spec.shape.body != nullptr) {
        setup.stock.width = spec.box.width;
        setup.stock.depth = spec.box.depth;
        setup.stock.height = spec.box.height;
        setup.shape = spec.shape;
        use(setup);
        return;
    }
    const bool fromFile = spec.shape.kind != StockKind::cylinder;
    if (fromFile && spec.shape.file.empty())
        return useNoStock(spec, setup);
    // A body from another file uses the position in that file.
    makeStock(spec, another && fromFile ? std::nullopt : std::optional(setup.stock.corner));
}

/// Runs in the background; the result is used with the values that the form has by then.
void SetupPanel::makeStock(const StockSpec& spec, const std::optional<Vec3>& corner) {
    m_problem->hide();
    if (!spec.shape.file.empty())
        m_memory->setText(tr("Reading %1…").arg(QFileInfo(toQString(spec.shape.file)).fileName()));
    m_making.start([this, spec, corner](const NewestTask::Reply& reply) {
        StockSpec made = spec;
        Result<void> done;
        try {
            done = proveout::makeStock(made, corner);
        } catch (const std::bad_alloc&) {
            done = failure(window_finding::kStockOutOfMemory);
        }
        reply.post([this, made, done] {
            if (done)
                useStock(made, edited(m_session.job().setup()));
            else {
                useNoStock(made, edited(m_session.job().setup()));
                showProblem(done.error());
            }
        });
    });
}

void SetupPanel::useStock(const StockSpec& spec, Setup setup) {
    const bool sameFile = setup.shape.kind == spec.shape.kind && setup.shape.file == spec.shape.file;
    setup.stock = spec.box;
    setup.shape = spec.shape;
    if (const auto spacing = spec.shape.body->spacing(); spacing && !sameFile)
        setup.spacing = *spacing;
    use(setup);
}

/// The shape cannot be created; no other stock may be simulated in its place.
void SetupPanel::useNoStock(const StockSpec& spec, Setup setup) {
    setup.shape = spec.shape;
    setup.shape.body.reset();
    use(setup);
}

/// If the stock or the grid is refused, the form keeps the input and everything else is used without it.
void SetupPanel::use(Setup setup) {
    showMemory(setup);
    const Result<void> done = m_session.job().setSetup(setup);
    if (done)
        return showStockProblem();
    const Setup& present = m_session.job().setup();
    m_stock->show(present);
    setup.stock = present.stock;
    setup.shape = present.shape;
    setup.spacing = present.spacing;
    setup.automaticGrid = present.automaticGrid;
    static_cast<void>(m_session.job().setSetup(setup)); // the first error is the one to report
    showProblem(done.error());
}

void SetupPanel::showProblem(const Diagnostics& errors) {
    m_problem->setText(sentence(errors.front()) + u' ' + hint(errors.front()));
    m_problem->show();
    showMemory(m_session.job().setup());
}

void SetupPanel::fitToProgram() {
    m_session.job().asOneStep([this] {
        Setup setup = edited(m_session.job().setup());
        setup.stock = m_session.job().stockFittedToProgram();
        setup.shape = {};
        m_making.cancel();
        m_stock->show(setup);
        use(setup);
    });
}

/// Marked with an asterisk while the tools have unsaved changes.
void SetupPanel::titleTools() {
    m_toolsTitle->setText(m_session.document().job().toolsModified() ? tr("Tools") + u'*' : tr("Tools"));
}

void SetupPanel::showTool(int number) {
    m_tools->edit(number);
    m_toolInView->keep();
}

void SetupPanel::retranslate() {
    m_programTitle->setText(tr("Control"));
    m_stockTitle->setText(tr("Stock and grid"));
    m_fixturesTitle->setText(tr("Fixtures"));
    m_fit->setText(tr("Fit to program"));
    m_fit->setToolTip(tr("Fit the stock to the toolpath"));
    titleTools();
    m_machineTitle->setText(tr("Machine"));
    m_define->setText(tr("Add missing tools (⌀ 10 mm assumed)"));
    m_define->setToolTip(tr("Add these tools; then enter the sizes of your cutters"));
    showMissingTools();
    showMemory(m_session.job().setup());
}

void SetupPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace proveout
