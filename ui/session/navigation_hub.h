// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <QObject>

#include "core/base/geometry.h"
#include "ui/program/block_search.h"

namespace proveout {

class PlaybackHub;
class ProblemsHub;
class ProgramHub;
class SimulationHub;
class WorkHub;

/// Navigation from a position on the stock to its block and back, and requests to show a line or a tool.
/// Thread: the UI thread.
class NavigationHub final : public QObject {
    Q_OBJECT

public:
    /// The hubs that are queried; all must outlive this object.
    struct Hubs {
        const ProgramHub& program;
        const SimulationHub& simulation;
        PlaybackHub& playback;
        ProblemsHub& problems;
        WorkHub& work;
    };
    explicit NavigationHub(const Hubs& hubs);

    /// Searches in the background for the block that cut a position, and goes there (placeFound()): its line
    /// is shown, and it becomes the last block that is cut. Pauses playback. If the current block, the
    /// program or its setup changes meanwhile, the search is discarded.
    void goToBlockThatMade(const PickedPlace& place);
    /// Returns to the block from which the last such jump started.
    void returnFromJump();
    [[nodiscard]] bool canReturn() const { return !m_leftBlocks.empty(); }
    /// Call it when the stored blocks belong to another program.
    void forgetJumps();

signals:
    /// Requests that the editor goes to a source line (1-based).
    void lineRequested(std::uint32_t line, int column);
    /// Requests that a tool of the table is shown, or that the tool with this number is defined.
    void toolRequested(int number);
    /// Requests that the view shows a place (program coordinates), and what is around it within a radius, mm.
    void placeRequested(const Vec3& place, double radius);
    /// The result of goToBlockThatMade().
    void placeFound(const PlaceAnswer& answer);

private:
    void goTo(const PlaceAnswer& answer);
    [[nodiscard]] bool isPresent(const Frame& moment) const;

    Hubs m_hubs;
    BlockSearch m_search;
    std::vector<std::size_t> m_leftBlocks; ///< the blocks from which goToBlockThatMade() jumped
};

} // namespace proveout
