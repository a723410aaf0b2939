// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editor/editor_panel.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <QEvent>
#include <QLabel>
#include <QLocale>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/simulation/run/interpretation.h"
#include "ui/editor/find_bar.h"
#include "ui/editor/nc_editor.h"
#include "ui/files/edited_elsewhere_bar.h"
#include "ui/files/file_changed_bar.h"
#include "ui/look/icons.h"
#include "ui/readout/problem_list.h"

namespace proveout {

namespace {

constexpr const char* kContext = "EditCommands";
constexpr int kFollowMargin = 8; // px
// Determine the width of the panel.
constexpr std::size_t kMeasuredLines = 2000;
constexpr double kUsualLines = 0.95; ///< share of the lines that must fit …
constexpr std::size_t kFarLonger = 2; ///< … and all lines must fit, unless the longest is more than this many
                                      ///< times as long

} // namespace

const std::array<Command<EditorPanel>, 12> EditorPanel::kCommands{{
    {"edit-cut", QT_TRANSLATE_NOOP("EditCommands", "Cu&t"),
     QT_TRANSLATE_NOOP("EditCommands", "Move the selected text to the clipboard"), "", "Ctrl+X", Reach::focus,
     [](EditorPanel& panel) { panel.m_editor->cut(); }},
    {"edit-copy", QT_TRANSLATE_NOOP("EditCommands", "&Copy"),
     QT_TRANSLATE_NOOP("EditCommands", "Copy the selected text to the clipboard"), "", "Ctrl+C", Reach::focus,
     [](EditorPanel& panel) { panel.m_editor->copy(); }},
    {"edit-paste", QT_TRANSLATE_NOOP("EditCommands", "&Paste"),
     QT_TRANSLATE_NOOP("EditCommands", "Insert the text from the clipboard"), "", "Ctrl+V", Reach::focus,
     [](EditorPanel& panel) { panel.m_editor->paste(); }},
    {"edit-delete", QT_TRANSLATE_NOOP("EditCommands", "&Delete"),
     QT_TRANSLATE_NOOP("EditCommands", "Delete the selected text"), "", "", Reach::focus,
     [](EditorPanel& panel) { panel.m_editor->removeSelectedText(); }},
    {"edit-select-all", QT_TRANSLATE_NOOP("EditCommands", "Select &All"),
     QT_TRANSLATE_NOOP("EditCommands", "Select all of the text"), "", "Ctrl+A", Reach::focus,
     [](EditorPanel& panel) { panel.m_editor->selectAll(); }},
    separator<EditorPanel>(),
    {"edit-find", QT_TRANSLATE_NOOP("EditCommands", "&Find…"),
     QT_TRANSLATE_NOOP("EditCommands", "Find text in the NC program"), "find", "Ctrl+F", Reach::window,
     [](EditorPanel& panel) { panel.m_find->open(false); }},
    {"edit-replace", QT_TRANSLATE_NOOP("EditCommands", "R&eplace…"),
     QT_TRANSLATE_NOOP("EditCommands", "Find text in the NC program and replace it"), "", "Ctrl+H",
     Reach::window, [](EditorPanel& panel) { panel.m_find->open(true); }},
    {"edit-find-next", QT_TRANSLATE_NOOP("EditCommands", "Find &Next"),
     QT_TRANSLATE_NOOP("EditCommands", "Go to the next match"), "", "F3", Reach::window,
     [](EditorPanel& panel) { panel.m_find->find(true); }},
    {"edit-find-previous", QT_TRANSLATE_NOOP("EditCommands", "Find Pre&vious"),
     QT_TRANSLATE_NOOP("EditCommands", "Go to the previous match"), "", "Shift+F3", Reach::window,
     [](EditorPanel& panel) { panel.m_find->find(false); }},
    {"toggle-breakpoint", QT_TRANSLATE_NOOP("EditCommands", "Toggle &Breakpoint"),
     QT_TRANSLATE_NOOP("EditCommands", "Set or remove a breakpoint at the cursor line"), "", "F9",
     Reach::window,
     [](EditorPanel& panel) {
         panel.m_session.breakpoints().toggle(static_cast<std::uint32_t>(panel.m_editor->caretLine()));
     }},
    {"edit-run-to-caret", QT_TRANSLATE_NOOP("EditCommands", "Run to Cur&sor"),
     QT_TRANSLATE_NOOP("EditCommands", "Show the stock after the cursor line"), "", "Ctrl+Return",
     Reach::focus,
     [](EditorPanel& panel) {
         panel.m_session.playback().seekToLine(static_cast<std::uint32_t>(panel.m_editor->caretLine()));
     }},
}};

EditorPanel::EditorPanel(Session& session, QWidget* parent)
    : QWidget(parent), m_session(session), m_editor(new NcEditor(this)), m_find(new FindBar(*m_editor, this)),
      m_changed(new FileChangedBar(session, FilePart::text, this)), m_readOnly(new QLabel(this)),
      m_follow(new QAction(this)), m_followAgain(new QToolButton(m_editor)),
      m_commands(*this, kContext, kCommands, this) {
    for (QAction* action : m_commands.all()) {
        addAction(action);
        m_editor->addAction(action); // its context menu
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(new EditedElsewhereBar(session, FilePart::text, this));
    layout->addWidget(m_changed);
    layout->addWidget(m_readOnly);
    layout->addWidget(m_editor, 1);
    layout->addWidget(m_find);
    m_readOnly->setContentsMargins(8, 4, 8, 4);
    m_readOnly->setWordWrap(true);
    m_editor->setFrameShape(QFrame::NoFrame);
    setFocusProxy(m_editor);

    connect(m_editor, &NcEditor::edited, &session.document(), &DocumentHub::applyEdit);
    connect(m_editor, &NcEditor::linesMoved, &session.breakpoints(), &BreakpointList::move);
    connect(m_editor, &NcEditor::marginChosen, &session,
            [&session](int line) { session.breakpoints().toggle(static_cast<std::uint32_t>(line)); });
    connect(&session.breakpoints(), &BreakpointList::changed, this, &EditorPanel::showBreakpoints);
    connect(m_editor, &NcEditor::savedStateChanged, &session.document(), &DocumentHub::setTextModified);
    connect(m_editor, &NcEditor::lineChosen, &session,
            [&session](int line) { session.playback().seekToLine(static_cast<std::uint32_t>(line)); });
    connect(m_editor, &NcEditor::valuesWanted, this,
            [this](std::uint32_t line) { askForValues(line, false); });
    connect(m_editor, &NcEditor::valuesUnwanted, &m_values, &ProgramSource::cancel);
    connect(&m_values, &ProgramSource::ready, this,
            [this](const std::shared_ptr<const Program>& program) { showValues(*program); });
    connect(m_editor, &QsciScintilla::selectionChanged, this, &EditorPanel::updateActions);
    connect(m_editor, &QsciScintilla::textChanged, this, &EditorPanel::updateActions);
    connect(m_editor, &NcEditor::loaded, this, [this] {
        updateActions();
        showProblems();
        showBreakpoints();
        showFrame(m_session.simulation().frame());
    });
    connect(&session.document(), &DocumentHub::textReplaced, this, &EditorPanel::loadText);
    connect(&session.document(), &DocumentHub::changed, this, [this] {
        if (!m_session.document().text().modified)
            m_editor->markSaved();
    });
    connect(&session.problems(), &ProblemsHub::changed, this, &EditorPanel::showProblems);
    connect(&session.check(), &CheckHub::changed, this, [this] {
        if (m_session.check().report()) // else the marks stay until the edited text is read
            showProblems();
    });
    connect(&session.program(), &ProgramHub::changed, this, [this] {
        if (m_session.program().current())
            m_editor->showDialect(m_session.program().current()->dialect());
        m_values.cancel();
        m_editor->showValues(nullptr);
    });
    connect(&session.playback(), &PlaybackHub::tick, this, &EditorPanel::showFrame);
    connect(&session.navigation(), &NavigationHub::lineRequested, this,
            [this](std::uint32_t line, int column) { m_editor->goTo(static_cast<int>(line), column); });
    makeFollowing();
    retranslate();
    loadText();
}

/// Measured in the document and not in the editor, which receives a long text only later.
QSize EditorPanel::sizeHint() const {
    const NcText& text = m_session.document().text().text;
    std::vector<std::size_t> lengths(std::min(text.lineCount(), kMeasuredLines));
    for (std::size_t i = 0; i < lengths.size(); ++i)
        lengths[i] = text.line(i).size();
    const auto usual =
        lengths.begin() + static_cast<std::ptrdiff_t>(static_cast<double>(lengths.size() - 1) * kUsualLines);
    std::nth_element(lengths.begin(), usual, lengths.end());
    const std::size_t longest = *std::max_element(usual, lengths.end());
    return {m_editor->widthOf(longest <= kFarLonger * *usual ? longest : *usual),
            QWidget::sizeHint().height()};
}

void EditorPanel::makeFollowing() {
    m_follow->setObjectName(QStringLiteral("follow-program"));
    m_follow->setCheckable(true);
    m_follow->setChecked(true);
    m_follow->setIcon(icon(QStringLiteral("path")));
    m_followAgain->setObjectName(QStringLiteral("follow-again"));
    m_followAgain->setDefaultAction(m_follow);
    m_followAgain->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_followAgain->setFocusPolicy(Qt::NoFocus); // so that the editor keeps the focus
    m_followAgain->hide();
    m_editor->installEventFilter(this);
    connect(m_follow, &QAction::triggered, this, &EditorPanel::chooseFollowing);
    connect(m_editor, &NcEditor::worked, this, &EditorPanel::pauseFollowing);
    connect(&m_session.playback(), &PlaybackHub::changed, this, &EditorPanel::followPlayback);
}

void EditorPanel::pauseFollowing() {
    if (!m_session.playback().state().playing || !m_follow->isChecked())
        return;
    m_followingPaused = true;
    m_follow->setChecked(false);
    showFollowing();
}

void EditorPanel::chooseFollowing(bool on) {
    m_followingPaused = false;
    if (on)
        m_editor->revealCurrentLine();
    showFollowing();
}

void EditorPanel::followPlayback() {
    const bool playing = m_session.playback().state().playing;
    const bool starts = playing && !m_wasPlaying;
    m_wasPlaying = playing;
    if (starts && std::exchange(m_followingPaused, false)) {
        m_follow->setChecked(true);
        m_editor->revealCurrentLine();
    }
    showFollowing();
}

/// The button is in the lower right corner of the text and does not shift it.
void EditorPanel::showFollowing() {
    m_followAgain->setVisible(m_session.playback().state().playing && !m_follow->isChecked());
    m_followAgain->adjustSize();
    const QRect text = m_editor->viewport()->geometry();
    m_followAgain->move(text.bottomRight() - m_followAgain->rect().bottomRight() -
                        QPoint(kFollowMargin, kFollowMargin));
    m_followAgain->raise();
}

bool EditorPanel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize && m_followAgain->isVisible())
        showFollowing();
    return QWidget::eventFilter(watched, event);
}

void EditorPanel::retranslate() {
    m_commands.retranslate();
    m_editor->setAccessibleName(tr("NC program"));
    m_follow->setText(tr("F&ollow Program"));
    m_follow->setToolTip(tr("Keep the current line in view during playback; typing, clicking or scrolling in "
                            "the text turns this off until playback is restarted"));
    showReadOnly();
}

void EditorPanel::showReadOnly() {
    const Document& document = m_session.document().text();
    m_readOnly->setVisible(document.readOnly);
    m_readOnly->setText(document.tooLongLine > 0
                            ? tr("Read-only, with lines truncated: line %1 has more than %2 characters.")
                                  .arg(locale().toString(static_cast<qulonglong>(document.tooLongLine)),
                                       locale().toString(static_cast<qulonglong>(kEditableLine)))
                            : tr("Read-only: the file is larger than 1 GB."));
}

void EditorPanel::loadText() {
    m_editor->load(m_session.document().text());
    showReadOnly();
}

void EditorPanel::updateActions() {
    const bool editable = !m_editor->isReadOnly();
    const bool selected = m_editor->hasSelectedText();
    m_commands.find("edit-cut")->setEnabled(editable && selected);
    m_commands.find("edit-copy")->setEnabled(selected);
    m_commands.find("edit-paste")->setEnabled(editable);
    m_commands.find("edit-delete")->setEnabled(editable && selected);
    m_commands.find("edit-replace")->setEnabled(editable);
}

void EditorPanel::askForValues(std::uint32_t line, bool toEnd) {
    if (!m_session.program().current())
        return;
    InterpretOptions options = interpretOptions(m_session.job().setup(), m_session.document().text().path,
                                                *m_session.program().current());
    options.watchedLine = line;
    options.watchToEnd = m_counts = toEnd;
    m_values.request(m_session.document().text().text, std::move(options));
}

/// First the values of the line, then how often it is executed.
void EditorPanel::showValues(const Program& program) {
    const auto& values = program.lineValues();
    m_editor->showValues(values);
    const bool again = m_session.program().current() && m_session.program().current()->runsAgain();
    if (!m_counts && again && values->executions > 0)
        askForValues(values->line, true);
}

void EditorPanel::showFrame(const FramePtr& frame) {
    if (!frame || frame->program != m_session.program().current()) {
        m_editor->showCurrentLine(0, false);
        return;
    }
    // While the user works in the text, it must not scroll away from the cursor.
    const bool resting = !m_session.playback().state().playing;
    const bool follow = m_follow->isChecked() ? !resting || !m_editor->hasFocus()
                                              : resting && m_followingPaused && !m_editor->hasFocus();
    const int line = frame->block > 0 ? static_cast<int>(frame->program->blockLine(frame->block - 1)) : 0;
    m_editor->showCurrentLine(line, follow);
}

void EditorPanel::showProblems() {
    Diagnostics here;
    for (CheckFinding& problem : problemsInText(m_session))
        here.push_back(std::move(problem.diagnostic));
    m_editor->showProblems(here);
}

void EditorPanel::showBreakpoints() {
    std::vector<int> on;
    std::vector<int> off;
    for (const Breakpoint& breakpoint : m_session.breakpoints().all()) {
        if (breakpoint.kind == BreakpointKind::line)
            (breakpoint.enabled ? on : off).push_back(static_cast<int>(breakpoint.line));
    }
    m_editor->showBreakpoints(on, off);
}

void EditorPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace proveout
