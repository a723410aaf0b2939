// SPDX-License-Identifier: GPL-3.0-or-later
// Finds in the background which block of the program cut a position on the stock.
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

/// A position on the stock that the user picked. Value type.
struct PickedPlace {
    FramePtr moment;               ///< whose z-map was hit: of the stock, or of a detail region; null: no hit
    std::optional<MapPoint> point; ///< empty: the outer side or the underside of the stock
};

/// What is known about such a position. Value type.
struct PlaceAnswer {
    enum class Kind : std::uint8_t {
        noStock,
        neverCut, ///< by no block up to `block`
        outdated, ///< program or setup have changed since that moment
        cut,      ///< by block `block`
    };
    Kind kind = Kind::noStock;
    std::size_t block = 0;    ///< blocks executed at that moment; for a cut, up to and including the block
                              ///< that made it
    std::uint32_t line = 0;   ///< for a cut: its source line, from 1
    int tool = 0;             ///< for a cut
    bool toolAssumed = false; ///< ToolChoice::isAssumed()

    friend bool operator==(const PlaceAnswer&, const PlaceAnswer&) = default;
};

/// Finds the block that cut a position on the stock. A new request replaces the previous one. Thread: UI.
class BlockSearch : public QObject {
    Q_OBJECT

public:
    /// Same signature as blockThatMade(), which is the default; called on a thread of its own.
    using Find = std::function<std::optional<std::size_t>(const Frame&, const MapPoint&, const WorkContext&)>;
    explicit BlockSearch(QObject* parent = nullptr, Find find = {});

    /// Discards the previous request. The point must be a point of the moment's z-map.
    void ask(const FramePtr& moment, const MapPoint& point);
    /// Discards the request; nothing more is reported about it.
    void cancel();
    /// In [0, 1] for a search that takes long enough to show progress; otherwise empty.
    [[nodiscard]] const std::optional<double>& done() const { return m_done; }

signals:
    void progressed();
    void answered(const PlaceAnswer& answer);
    void failed(const Diagnostics& errors);

private:
    using Reply = NewestTask::Reply;
    void carryOut(const FramePtr& moment, const MapPoint& point, const Reply& reply);
    void finish();

    Find m_find; ///< used only on the task's thread
    QTimer m_patience;
    std::optional<double> m_done;
    NewestTask m_task; ///< last member: its thread must end before what it uses is destroyed
};

} // namespace proveout
