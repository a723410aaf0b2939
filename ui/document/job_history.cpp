// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/job_history.h"

#include <utility>

#include <QUndoCommand>

#include "ui/document/job_step_name.h"

namespace proveout {

namespace {

constexpr int kMostSteps = 200;

class Step final : public QUndoCommand {
public:
    Step(const JobHistory::Change& change, JobValues before, JobValues after, int visit)
        : m_change(change), m_before(std::move(before)), m_after(std::move(after)), m_visit(visit) {}

    [[nodiscard]] QString name() const { return jobStepName(m_before, m_after).text; }
    [[nodiscard]] int id() const override { return jobStepName(m_before, m_after).field; }

    void undo() override { m_change(m_after, m_before); }
    void redo() override {
        if (std::exchange(m_isDone, true)) // QUndoStack calls redo() on a pushed command
            m_change(m_before, m_after);
    }

    bool mergeWith(const QUndoCommand* other) override {
        const auto& next = static_cast<const Step&>(*other);
        if (next.m_visit != m_visit)
            return false;
        m_after = next.m_after;
        setObsolete(sameValues(m_before, m_after));
        return true;
    }

private:
    const JobHistory::Change& m_change;
    JobValues m_before;
    JobValues m_after;
    int m_visit;
    bool m_isDone = false;
};

} // namespace

JobHistory::JobHistory(Change change, QObject* parent) : QObject(parent), m_change(std::move(change)) {
    m_stack.setUndoLimit(kMostSteps);
    connect(&m_stack, &QUndoStack::indexChanged, this, &JobHistory::changed);
}

void JobHistory::record(const JobValues& before, const JobValues& after) {
    m_stack.push(new Step(m_change, before, after, m_visit));
}

void JobHistory::clear() {
    m_stack.clear();
    emit changed();
}

QString JobHistory::nameOf(int index) const {
    const auto* step = static_cast<const Step*>(m_stack.command(index));
    return step == nullptr ? QString() : step->name();
}

QString JobHistory::undoName() const {
    return nameOf(m_stack.index() - 1);
}

QString JobHistory::redoName() const {
    return nameOf(m_stack.index());
}

void JobHistory::undo() {
    closeStep();
    m_stack.undo();
}

void JobHistory::redo() {
    closeStep();
    m_stack.redo();
}

} // namespace proveout
