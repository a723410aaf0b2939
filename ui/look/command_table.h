// SPDX-License-Identifier: GPL-3.0-or-later
// Commands of the window: one row per command, used by menus, tool bars and tests.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include <QAction>
#include <QCoreApplication>
#include <QKeySequence>
#include <QObject>

#include "ui/look/icons.h"

namespace proveout {

/// Where the shortcut of a command is active.
enum class Reach {
    window, ///< everywhere in the main window
    focus,  ///< while one of the widgets that the action was added to has the focus
};

/// A command on a `Target`. Texts are literals marked with QT_TRANSLATE_NOOP in the context that the table is
/// created with. An empty text is a separator.
template<class Target>
struct Command {
    const char* id;   ///< stable, also the action's objectName
    const char* text; ///< with & before the mnemonic
    const char* tip;
    const char* icon; ///< in :/icons, may be empty
    const char* keys; ///< portable text, several separated by "; "; may be empty
    Reach reach;
    void (*run)(Target&);
};

template<class Target>
constexpr Command<Target> separator() {
    return {"", "", "", "", "", Reach::window, nullptr};
}

/// The actions of a table, owned by `owner`.
template<class Target>
class CommandActions {
public:
    /// `rows` and `context` must have static lifetime.
    CommandActions(Target& target, const char* context, std::span<const Command<Target>> rows, QObject* owner)
        : m_context(context), m_rows(rows) {
        for (const Command<Target>& row : rows)
            m_actions.push_back(make(target, row, owner));
        retranslate();
    }

    void retranslate() {
        for (std::size_t i = 0; i < m_rows.size(); ++i) {
            if (*m_rows[i].text == '\0')
                continue;
            m_actions[i]->setText(QCoreApplication::translate(m_context, m_rows[i].text));
            const QString tip = QCoreApplication::translate(m_context, m_rows[i].tip);
            const QString keys = m_actions[i]->shortcut().toString(QKeySequence::NativeText);
            m_actions[i]->setToolTip(keys.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, keys));
            m_actions[i]->setStatusTip(tip);
        }
    }

    /// One action per row, including separators.
    [[nodiscard]] const std::vector<QAction*>& all() const { return m_actions; }
    [[nodiscard]] std::span<const Command<Target>> rows() const { return m_rows; }
    /// Null if no row has that id.
    [[nodiscard]] QAction* find(std::string_view id) const {
        for (std::size_t i = 0; i < m_rows.size(); ++i) {
            if (id == m_rows[i].id)
                return m_actions[i];
        }
        return nullptr;
    }

private:
    static QAction* make(Target& target, const Command<Target>& row, QObject* owner) {
        auto* action = new QAction(owner);
        if (*row.text == '\0') {
            action->setSeparator(true);
            return action;
        }
        action->setObjectName(QLatin1String(row.id));
        if (*row.icon != '\0')
            action->setIcon(icon(QLatin1String(row.icon)));
        if (*row.keys != '\0')
            action->setShortcuts(QKeySequence::listFromString(QLatin1String(row.keys)));
        action->setShortcutContext(row.reach == Reach::window ? Qt::WindowShortcut
                                                              : Qt::WidgetWithChildrenShortcut);
        QObject::connect(action, &QAction::triggered, owner, [&target, &row] { row.run(target); });
        return action;
    }

    const char* m_context;
    std::span<const Command<Target>> m_rows;
    std::vector<QAction*> m_actions;
};

} // namespace proveout
