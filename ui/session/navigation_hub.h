// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <QObject>

#include "ui/program/block_search.h"

namespace proveout {

class PlaybackHub;
class ProblemsHub;
class ProgramHub;
class SimulationHub;
class WorkHub;

/// From a place of the stock to its block and back, and requests to show a line or a tool. Thread: the UI
/// thread.
class NavigationHub final : public QObject {
    Q_OBJECT

public:
    /// The hubs that answer; all outlive it.
    struct Hubs {
        const ProgramHub& program;
        const SimulationHub& simulation;
        PlaybackHub& playback;
        ProblemsHub& problems;
        WorkHub& work;
    };
    explicit NavigationHub(const Hubs& hubs);

    /// Looks in the background for the block that made a place, and goes there (placeFound()): its line is
    /// asked to be seen, and it is the last block that is cut. Pauses. Whatever else moves the play head, or
    /// changes the program or its setup, makes the question void.
    void goToBlockThatMade(const PickedPlace& place);
    /// To where the play head was before it went there the last time.
    void returnFromJump();
    [[nodiscard]] bool canReturn() const { return !m_leftBlocks.empty(); }
    /// The blocks that were left are those of another program.
    void forgetJumps();

signals:
    /// Someone asks to see a source line (1-based): the editor goes there.
    void lineRequested(std::uint32_t line, int column);
    /// Someone asks to see a tool of the table, or to define the one with this number.
    void toolRequested(int number);
    /// The answer to goToBlockThatMade().
    void placeFound(const PlaceAnswer& answer);

private:
    void goTo(const PlaceAnswer& answer);
    [[nodiscard]] bool isPresent(const Frame& moment) const;

    Hubs m_hubs;
    BlockSearch m_search;
    std::vector<std::size_t> m_leftBlocks; ///< where goToBlockThatMade() has led away from
};

} // namespace proveout
