// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QObject>
#include <QString>
#include <QUndoStack>

#include "ui/document/job_document.h"

namespace proveout {

/// The user's steps in setup, parameters and machine, to be undone and redone. A step bears the name of the
/// field that it changes; steps in the same field are one until closeStep(). Thread: UI.
class JobHistory final : public QObject {
    Q_OBJECT

public:
    /// Brings what differs between two states from the first to the second.
    using Change = std::function<void(const JobValues& from, const JobValues& to)>;

    /// `change` lives as long as the history; it records nothing.
    explicit JobHistory(Change change, QObject* parent = nullptr);

    /// The user has changed `before` into `after`.
    void record(const JobValues& before, const JobValues& after);
    /// What comes next is a step of its own, also where it changes the same field again.
    void closeStep() { ++m_visit; }
    /// Another document: nothing can be undone.
    void clear();

    [[nodiscard]] bool canUndo() const { return m_stack.canUndo(); }
    [[nodiscard]] bool canRedo() const { return m_stack.canRedo(); }
    /// What undo() changes, in the user's language; empty where there is nothing to undo.
    [[nodiscard]] QString undoName() const;
    [[nodiscard]] QString redoName() const;
    void undo();
    void redo();

signals:
    void changed();

private:
    [[nodiscard]] QString nameOf(int index) const;

    Change m_change;
    QUndoStack m_stack;
    int m_visit = 0;
};

} // namespace proveout
