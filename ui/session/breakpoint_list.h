// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <QObject>

#include "core/simulation/thread/breakpoints.h"

namespace proveout {

class SimulationHub;

/// The breakpoints of the document. Thread: the UI thread.
class BreakpointList final : public QObject {
    Q_OBJECT

public:
    /// `simulation` outlives it.
    explicit BreakpointList(SimulationHub& simulation) : m_simulation(simulation) {}

    [[nodiscard]] const std::vector<Breakpoint>& all() const { return m_breakpoints; }
    void set(std::vector<Breakpoint> breakpoints);
    /// Where there is the same already, it is switched on.
    void add(const Breakpoint& added);
    /// Sets one at a line, or removes it.
    void toggle(std::uint32_t line);
    /// An edit has added (or removed) lines after a place in `line`: breakpoints after it move along.
    void move(std::uint32_t line, bool fromItsStart, std::ptrdiff_t added);
    /// Posts them again: a load forgets them.
    void post();

signals:
    void changed();

private:
    SimulationHub& m_simulation;
    std::vector<Breakpoint> m_breakpoints;
};

} // namespace proveout
