// SPDX-License-Identifier: GPL-3.0-or-later
// The place of the surface under the pointer, and the block that made it.
#pragma once

#include <optional>

#include <QObject>
#include <QTimer>

#include "core/base/geometry.h"
#include "core/nc/program/active_offset.h"
#include "ui/program/block_search.h"

namespace proveout {

/// A place of the surface. Value type.
struct SurfacePlace {
    PickedPlace picked; ///< its moment is not null
    Vec3 at{0};         ///< in the coordinates of the program's motions
};

/// What is shown of the pointer wherever it is shown. Its block is looked for in the background, once the
/// pointer rests for a moment on the same point of the grid; another point, or another height of it, makes
/// the search void. Thread: UI.
class SurfaceProbe : public QObject {
    Q_OBJECT

public:
    /// `find` as of BlockSearch.
    explicit SurfaceProbe(QObject* parent = nullptr, BlockSearch::Find find = {});

    static constexpr int kRestMilliseconds = 100;

    /// The pointer is at that place now, or at none. `present`: its program is the one that the user reads.
    void point(const std::optional<SurfacePlace>& place, bool present = true);

    [[nodiscard]] const std::optional<SurfacePlace>& place() const { return m_place; }
    /// Of the place: in the work offset that is in force.
    [[nodiscard]] Vec3 workPosition() const { return m_place->at - m_offset.zero; }
    [[nodiscard]] const ActiveOffset& offset() const { return m_offset; }
    /// Nothing while it is looked for, or where the program is another one.
    [[nodiscard]] const std::optional<PlaceAnswer>& answer() const { return m_answer; }

signals:
    /// Another place, or none.
    void moved();
    void answered();

private:
    [[nodiscard]] bool isAnswered(const SurfacePlace& place) const;
    void followOffset();
    void ask();

    std::optional<SurfacePlace> m_place;
    std::optional<SurfacePlace> m_asked; ///< what m_answer, or the search under way, is about
    std::optional<PlaceAnswer> m_answer;
    ActiveOffset m_offset;
    FramePtr m_offsetOf;
    QTimer m_rest;
    BlockSearch m_search;
};

} // namespace proveout
