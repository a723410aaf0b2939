// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <QObject>

#include "core/simulation/setup/setup.h"
#include "ui/document/file_watch.h"
#include "ui/work/newest_task.h"

namespace proveout {

class JobHub;
class ProblemsHub;

/// The file that the stock of the setup was read from: a change on disk is a problem until the user decides.
/// Thread: the UI thread; the file is read in the background.
class StockFileHub final : public QObject {
    Q_OBJECT

public:
    /// Both must outlive this object.
    StockFileHub(JobHub& job, ProblemsHub& problems);

    /// Reads the stock again.
    void reload();
    /// Keeps the loaded stock until it is read again.
    void keep();

signals:
    /// The file has changed since it was read; false: it matches again, or another file is watched.
    void changedOnDisk(bool changed);

private:
    void watch();
    void watchedChanged();
    void report(bool changed);
    void adopt(const StockBox& box, const StockShape& shape);

    JobHub& m_job;
    ProblemsHub& m_problems;
    FileWatch m_watch;
    std::shared_ptr<const StockBody> m_watched; ///< the stock that was read from the file of m_watch
    NewestTask m_reading;
};

} // namespace proveout
