// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>

#include <QObject>

#include "core/base/diagnostic.h"
#include "core/formats/part_file.h"
#include "core/simulation/run/frame.h"
#include "core/verification/part/part_comparison.h"
#include "ui/work/newest_task.h"

namespace proveout {

class JobHub;
class SimulationHub;

/// The design part of the job, and the stock of the moment compared with it. Files are read and stocks
/// compared in the background, each on one thread of low priority; a change cancels what it makes void.
/// Thread: the UI thread.
class PartHub final : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this object.
    PartHub(const JobHub& job, const SimulationHub& simulation);

    /// What the file holds, placed; without a part if there is none, or it cannot be used.
    [[nodiscard]] const PartContents& contents() const { return m_contents; }
    /// Whether the file is being read.
    [[nodiscard]] bool isReading() const { return m_isReading; }

    /// The comparison of the newest moment at rest; null while it is not known, and if there is none. While
    /// other moments are shown, the last one stays.
    [[nodiscard]] const std::shared_ptr<const PartComparison>& comparison() const { return m_comparison; }
    /// The blocks that were executed in that moment.
    [[nodiscard]] std::size_t block() const { return m_compared ? m_compared->block : 0; }
    /// Why nothing is compared, and what concerns the place of the part.
    [[nodiscard]] const Diagnostics& placement() const { return m_placement; }
    /// In [0, 1] while a comparison is awaited.
    [[nodiscard]] const std::optional<double>& progress() const { return m_progress; }

    /// Moments are compared while anybody looks at the result, until the last one does not or is destroyed.
    void setOn(const QObject& user, bool on);
    /// Bytes that the part, and then a comparison, may allocate, instead of a quarter of memoryLimitBytes().
    void setMemoryLimit(std::uint64_t bytes);
    /// Reads the file again.
    void reread();

signals:
    /// contents() or isReading() has changed.
    void partChanged();
    /// comparison(), placement() or progress() has changed.
    void changed();

private:
    void leave(const QObject* user);
    void adopt();
    void read();
    void compare();
    void clear();
    [[nodiscard]] std::uint64_t memory() const;
    /// Whether the part can be compared with the stock of a frame; sets placement().
    [[nodiscard]] bool fits(const Frame& frame);

    const JobHub& m_job;
    const SimulationHub& m_simulation;
    std::optional<PartSpec> m_read; ///< what m_contents are of
    PartContents m_contents;
    bool m_isReading = false;
    std::set<const QObject*> m_users; ///< that look
    std::shared_ptr<const PartComparison> m_comparison;
    FramePtr m_compared; ///< the moment of m_comparison, or the one that is being compared
    PartTolerance m_tolerance;
    Diagnostics m_placement;
    std::optional<double> m_progress;
    std::optional<std::uint64_t> m_memoryLimit;
    NewestTask m_reading;
    NewestTask m_comparing;
};

} // namespace proveout
