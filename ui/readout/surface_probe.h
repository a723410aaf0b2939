// SPDX-License-Identifier: GPL-3.0-or-later
// The surface position under the pointer, and the block that cut it.
#pragma once

#include <optional>

#include <QObject>
#include <QTimer>

#include "core/base/geometry.h"
#include "core/nc/program/active_offset.h"
#include "ui/program/block_search.h"

namespace proveout {

/// A position on the surface. Value type.
struct SurfacePlace {
    PickedPlace picked; ///< its moment is not null
    Vec3 at{0};         ///< in the coordinates of the program's motions
};

/// The readout at the pointer. The block that made the surface there is searched in the background once the
/// pointer has rested for a moment on the same grid point; moving to another point, or a change of its
/// height, discards the search. Thread: UI.
class SurfaceProbe : public QObject {
    Q_OBJECT

public:
    /// `find`: see BlockSearch.
    explicit SurfaceProbe(QObject* parent = nullptr, BlockSearch::Find find = {});

    static constexpr int kRestMilliseconds = 100;

    /// The pointer is at this position now, or not on the surface. `present`: its program is the current one.
    void point(const std::optional<SurfacePlace>& place, bool present = true);

    [[nodiscard]] const std::optional<SurfacePlace>& place() const { return m_place; }
    /// The position relative to the active work offset.
    [[nodiscard]] Vec3 workPosition() const { return m_place->at - m_offset.zero; }
    [[nodiscard]] const ActiveOffset& offset() const { return m_offset; }
    /// Empty while the search is running, or if the program is not the current one.
    [[nodiscard]] const std::optional<PlaceAnswer>& answer() const { return m_answer; }

signals:
    /// The position has changed, or there is none now.
    void moved();
    void answered();

private:
    [[nodiscard]] bool isAnswered(const SurfacePlace& place) const;
    void followOffset();
    void ask();

    std::optional<SurfacePlace> m_place;
    std::optional<SurfacePlace> m_asked; ///< the position that m_answer or the current search belongs to
    std::optional<PlaceAnswer> m_answer;
    ActiveOffset m_offset;
    FramePtr m_offsetOf;
    QTimer m_rest;
    BlockSearch m_search;
};

} // namespace proveout
