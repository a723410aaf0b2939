// SPDX-License-Identifier: GPL-3.0-or-later
// Which block of the program made a place of the stock, found in the background.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include <QObject>
#include <QTimer>

#include "core/base/diagnostic.h"
#include "core/base/work_context.h"
#include "core/simulation/records/block_provenance.h"
#include "core/simulation/run/frame.h"
#include "ui/work/newest_task.h"

namespace proveout {

/// A place of the stock that somebody points at. Value type.
struct PickedPlace {
    FramePtr moment;               ///< whose map was met: of the stock, or of a closer look; null: none was
    std::optional<MapPoint> point; ///< nothing: the outer side or the underside of the stock
};

/// What is known of such a place. Value type.
struct PlaceAnswer {
    enum class Kind : std::uint8_t {
        noStock,
        neverCut, ///< up to `block`
        outdated, ///< the program or its set-up is no longer that of the moment
        cut,      ///< by block `block`
    };
    Kind kind = Kind::noStock;
    std::size_t block = 0;    ///< that many are executed at that moment; of a cut, with the one that made it
    std::uint32_t line = 0;   ///< of a cut: its source line, from 1
    int tool = 0;             ///< of a cut
    bool toolAssumed = false; ///< ToolChoice::isAssumed()

    friend bool operator==(const PlaceAnswer&, const PlaceAnswer&) = default;
};

/// Asks the motions of the program; the newest question counts. Thread: UI.
class BlockSearch : public QObject {
    Q_OBJECT

public:
    /// As blockThatMade(), which it is where none is given; called on a thread of its own.
    using Find = std::function<std::optional<std::size_t>(const Frame&, const MapPoint&, const WorkContext&)>;
    explicit BlockSearch(QObject* parent = nullptr, Find find = {});

    /// What was asked before is forgotten. The point is one of the moment's map.
    void ask(const FramePtr& moment, const MapPoint& point);
    /// Forgets the question: nothing is told of it any more.
    void cancel();
    /// In [0, 1], of a question that takes long enough to be told of; else nothing.
    [[nodiscard]] const std::optional<double>& done() const { return m_done; }

signals:
    void progressed();
    void answered(const PlaceAnswer& answer);
    void failed(const Diagnostics& errors);

private:
    using Reply = NewestTask::Reply;
    void carryOut(const FramePtr& moment, const MapPoint& point, const Reply& reply);
    void finish();

    Find m_find; ///< used on the thread of the task only
    QTimer m_patience;
    std::optional<double> m_done;
    NewestTask m_task; ///< last: its thread ends before what it uses
};

} // namespace proveout
