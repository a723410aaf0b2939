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
    /// `simulation` must outlive this object.
    explicit BreakpointList(SimulationHub& simulation) : m_simulation(simulation) {}

    [[nodiscard]] const std::vector<Breakpoint>& all() const { return m_breakpoints; }
    void set(std::vector<Breakpoint> breakpoints);
    /// If an equal breakpoint exists, it is enabled instead.
    void add(const Breakpoint& added);
    /// Adds a breakpoint at a line, or removes the existing one.
    void toggle(std::uint32_t line);
    /// An edit has added (or removed) lines after a position in `line`: breakpoints after it move along.
    void move(std::uint32_t line, bool fromItsStart, std::ptrdiff_t added);
    /// Sends the breakpoints to the simulation again, because loading clears them.
    void post();

signals:
    void changed();

private:
    SimulationHub& m_simulation;
    std::vector<Breakpoint> m_breakpoints;
};

} // namespace proveout
