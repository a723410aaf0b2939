// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/readout/surface_probe.h"

#include <utility>

namespace proveout {
namespace {

float heightOf(const SurfacePlace& place) {
    return place.picked.moment->zmap.height(place.picked.point->i, place.picked.point->j);
}

/// Whether both positions were cut by the same block, namely the first one that reached the height of the
/// point.
bool isSameCut(const SurfacePlace& a, const SurfacePlace& b) {
    const Frame& now = *a.picked.moment;
    const Frame& then = *b.picked.moment;
    return a.picked.point && a.picked.point == b.picked.point && now.program == then.program &&
           now.setup == then.setup && now.zmap.grid() == then.zmap.grid() && heightOf(a) == heightOf(b);
}

} // namespace

SurfaceProbe::SurfaceProbe(QObject* parent, BlockSearch::Find find)
    : QObject(parent), m_search(nullptr, std::move(find)) {
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestMilliseconds);
    connect(&m_rest, &QTimer::timeout, this, &SurfaceProbe::ask);
    connect(&m_search, &BlockSearch::answered, this, [this](const PlaceAnswer& answer) {
        m_answer = answer;
        emit answered();
    });
}

bool SurfaceProbe::isAnswered(const SurfacePlace& place) const {
    if (!m_asked || !isSameCut(place, *m_asked))
        return false;
    // Before that block, another one may have cut to the same depth.
    return !m_answer || m_answer->kind != PlaceAnswer::Kind::cut ||
           m_answer->block <= place.picked.moment->block;
}

void SurfaceProbe::followOffset() {
    const FramePtr& moment = m_place->picked.moment;
    if (std::exchange(m_offsetOf, moment) != moment)
        m_offset = moment->program ? activeOffset(*moment->program, moment->block) : ActiveOffset();
}

void SurfaceProbe::point(const std::optional<SurfacePlace>& place, bool present) {
    const bool wasThere = m_place.has_value();
    m_place = place;
    if (place)
        followOffset();
    if (!place || !present || !isAnswered(*place)) {
        m_rest.stop();
        m_search.cancel();
        m_asked.reset();
        m_answer.reset();
        if (place && present && place->picked.point) {
            m_asked = place;
            m_rest.start();
        } else if (place && present) { // the outer side or the underside
            m_answer = PlaceAnswer{PlaceAnswer::Kind::neverCut, place->picked.moment->block};
        }
    }
    if (wasThere || place)
        emit moved();
}

void SurfaceProbe::ask() {
    m_search.ask(m_asked->picked.moment, *m_asked->picked.point);
}

} // namespace proveout
