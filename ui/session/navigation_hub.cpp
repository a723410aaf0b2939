// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/navigation_hub.h"

#include <utility>

#include "ui/session/playback_hub.h"
#include "ui/session/problems_hub.h"
#include "ui/session/program_hub.h"
#include "ui/session/simulation_hub.h"
#include "ui/session/work_hub.h"

namespace proveout {

NavigationHub::NavigationHub(const Hubs& hubs) : m_hubs(hubs) {
    hubs.work.setCancel(WorkKind::searching, [this] { m_search.cancel(); });
    connect(&hubs.program, &ProgramHub::outdated, &m_search, &BlockSearch::cancel);
    connect(&hubs.playback, &PlaybackHub::headSent, &m_search, &BlockSearch::cancel);
    connect(&m_search, &BlockSearch::progressed, this,
            [this] { m_hubs.work.set(WorkKind::searching, m_search.done()); });
    connect(&m_search, &BlockSearch::answered, this, &NavigationHub::goTo);
    connect(&m_search, &BlockSearch::failed, &hubs.problems, &ProblemsHub::report);
}

void NavigationHub::goToBlockThatMade(const PickedPlace& place) {
    using Kind = PlaceAnswer::Kind;
    const std::size_t block = m_hubs.simulation.block();
    m_search.cancel();
    if (place.moment == nullptr)
        emit placeFound({Kind::noStock, block});
    else if (!isPresent(*place.moment))
        emit placeFound({Kind::outdated, block});
    else if (!place.point)
        emit placeFound({Kind::neverCut, place.moment->block});
    else {
        m_hubs.playback.pause();
        m_search.ask(place.moment, *place.point);
    }
}

/// False after a pending edit, because it has moved the lines already.
bool NavigationHub::isPresent(const Frame& moment) const {
    return m_hubs.program.isUpToDate() && moment.program == m_hubs.program.current() &&
           m_hubs.simulation.runsOn(moment.setup);
}

void NavigationHub::goTo(const PlaceAnswer& answer) {
    if (answer.kind == PlaceAnswer::Kind::cut) {
        const std::size_t block = m_hubs.simulation.block();
        if (block != answer.block) {
            m_leftBlocks.push_back(block);
            emit m_hubs.playback.changed();
        }
        m_hubs.playback.seek(answer.block);
        emit lineRequested(answer.line, 1);
    }
    emit placeFound(answer);
}

void NavigationHub::returnFromJump() {
    if (m_leftBlocks.empty())
        return;
    const std::size_t block = m_leftBlocks.back();
    m_leftBlocks.pop_back();
    m_hubs.playback.pause();
    m_hubs.playback.seek(block);
    emit m_hubs.playback.changed();
}

void NavigationHub::forgetJumps() {
    if (!std::exchange(m_leftBlocks, {}).empty())
        emit m_hubs.playback.changed();
}

} // namespace proveout
