// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QObject>
#include <QString>
#include <QUndoStack>

#include "ui/document/job_document.h"

namespace proveout {

/// Undo and redo of the user's steps in setup, parameters and machine. A step is named after the field that
/// it changes; consecutive steps in the same field merge until closeStep(). Thread: UI.
class JobHistory final : public QObject {
    Q_OBJECT

public:
    /// Applies the differences between the two states.
    using Change = std::function<void(const JobValues& from, const JobValues& to)>;

    /// `change` must remain valid as long as the history; it must not record anything.
    explicit JobHistory(Change change, QObject* parent = nullptr);

    /// Records that the user has changed `before` into `after`.
    void record(const JobValues& before, const JobValues& after);
    /// The next change becomes a separate step, even if it changes the same field again.
    void closeStep() { ++m_visit; }
    /// Call it for another document: clears all steps.
    void clear();

    [[nodiscard]] bool canUndo() const { return m_stack.canUndo(); }
    [[nodiscard]] bool canRedo() const { return m_stack.canRedo(); }
    /// What undo() changes, in the user's language; empty if there is nothing to undo.
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
