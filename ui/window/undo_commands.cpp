// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/undo_commands.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QApplication>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSpinBox>

#include "ui/editor/editor_panel.h"
#include "ui/editor/nc_editor.h"
#include "ui/look/typed_text.h"

namespace proveout {

namespace {

constexpr const char* kContext = "EditCommands";

const std::array<Command<UndoCommands>, 3> kCommands{{
    {"edit-undo", QT_TRANSLATE_NOOP("EditCommands", "&Undo"),
     QT_TRANSLATE_NOOP("EditCommands",
                       "Undo the last change where the focus is: program text, or setup, tuning and machine"),
     "undo", "Ctrl+Z", Reach::window, [](UndoCommands& commands) { commands.undo(); }},
    {"edit-redo", QT_TRANSLATE_NOOP("EditCommands", "&Redo"),
     QT_TRANSLATE_NOOP("EditCommands", "Redo the last undone change"), "redo", "Ctrl+Shift+Z; Ctrl+Y",
     Reach::window, [](UndoCommands& commands) { commands.redo(); }},
    separator<UndoCommands>(),
}};

/// Whether the focus is on text that is being typed and is not a value yet: such text has its own undo.
bool isTyping(const QWidget& focus) {
    if (const auto* box = qobject_cast<const QSpinBox*>(&focus))
        return isBeingTyped(*box);
    if (const auto* box = qobject_cast<const QDoubleSpinBox*>(&focus))
        return isBeingTyped(*box);
    const auto* line = qobject_cast<const QLineEdit*>(&focus);
    return line != nullptr && line->isModified() && (line->isUndoAvailable() || line->isRedoAvailable());
}

/// Escapes &, which would mark a mnemonic in the text of a menu.
QString plain(QString name) {
    return name.replace(u'&', QStringLiteral("&&"));
}

} // namespace

UndoCommands::UndoCommands(Session& session, EditorPanel& editor, QList<const QWidget*> jobPanels,
                           QObject* parent)
    : QObject(parent), m_session(session), m_editor(editor), m_jobPanels(std::move(jobPanels)),
      m_actions(*this, kContext, kCommands, this) {
    // The context menu of the text starts with these commands too.
    NcEditor& text = editor.editor();
    text.insertActions(text.actions().value(0), {m_actions.all().begin(), m_actions.all().end()});
    connect(qApp, &QApplication::focusChanged, this,
            [this](const QWidget*, const QWidget* focus) { focusMoved(focus); });
    connect(&session.job().history(), &JobHistory::changed, this, &UndoCommands::jobChanged);
    connect(&text, &QsciScintilla::textChanged, this, &UndoCommands::update);
    connect(&text, &NcEditor::loaded, this, &UndoCommands::update);
    qApp->installEventFilter(this);
    update();
}

void UndoCommands::undo() {
    if (m_ofText)
        m_editor.editor().undo();
    else
        m_session.job().undoStep();
}

void UndoCommands::redo() {
    if (m_ofText)
        m_editor.editor().redo();
    else
        m_session.job().redoStep();
}

bool UndoCommands::isInJobPanel(const QWidget& widget) const {
    return std::ranges::any_of(m_jobPanels, [&widget](const QWidget* panel) {
        return panel == &widget || panel->isAncestorOf(&widget);
    });
}

bool UndoCommands::isInEditor(const QWidget& widget) const {
    return &widget == &m_editor || m_editor.isAncestorOf(&widget);
}

/// Menus, the 3D view and the like have nothing to undo, so the previously focused input still counts.
void UndoCommands::focusMoved(const QWidget* focus) {
    if (focus == nullptr)
        return;
    m_session.job().history().closeStep();
    if (isInEditor(*focus))
        m_ofText = true;
    else if (isInJobPanel(*focus))
        m_ofText = false;
    update();
}

/// The job may also be changed by a command elsewhere, e.g. in the Mesh menu.
void UndoCommands::jobChanged() {
    const QWidget* focus = QApplication::focusWidget();
    if (focus == nullptr || !isInEditor(*focus))
        m_ofText = false;
    update();
}

void UndoCommands::retranslate() {
    m_actions.retranslate();
    update();
}

void UndoCommands::update() {
    const NcEditor& text = m_editor.editor();
    const JobHistory& steps = m_session.job().history();
    const bool writable = !text.isReadOnly();
    const QString change = tr("Text change");
    QAction& undo = *m_actions.find("edit-undo");
    QAction& redo = *m_actions.find("edit-redo");
    undo.setEnabled(m_ofText ? writable && text.isUndoAvailable() : steps.canUndo());
    redo.setEnabled(m_ofText ? writable && text.isRedoAvailable() : steps.canRedo());
    undo.setText(undo.isEnabled() ? tr("&Undo %1").arg(plain(m_ofText ? change : steps.undoName()))
                                  : QCoreApplication::translate(kContext, kCommands[0].text));
    redo.setText(redo.isEnabled() ? tr("&Redo %1").arg(plain(m_ofText ? change : steps.redoName()))
                                  : QCoreApplication::translate(kContext, kCommands[1].text));
}

bool UndoCommands::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::ShortcutOverride || !watched->isWidgetType())
        return false;
    // The input fields of the panels would use these keys for their own text, even if it has nothing to undo.
    const auto& key = static_cast<const QKeyEvent&>(*event);
    const auto& widget = static_cast<const QWidget&>(*watched);
    const QKeySequence pressed(key.keyCombination());
    const auto isOurs = [&](const QAction* action) { return action->shortcuts().contains(pressed); };
    if (std::ranges::none_of(m_actions.all(), isOurs) || !isInJobPanel(widget) || isTyping(widget))
        return false;
    event->ignore();
    return true;
}

} // namespace proveout
