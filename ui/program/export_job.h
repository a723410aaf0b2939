// SPDX-License-Identifier: GPL-3.0-or-later
// Exports the stock in the background.
#pragma once

#include <cstdint>
#include <functional>
#include <thread>

#include <QObject>
#include <QString>

#include "core/base/diagnostic.h"
#include "core/base/memory.h"
#include "core/base/work_context.h"
#include "core/formats/formats.h"
#include "core/simulation/run/frame.h"
#include "ui/work/ui_queue.h"

namespace proveout {

struct ExportOptions {
    bool decimated = true;              ///< every region is decimated, regardless of the period; false: the
                                        ///< full mesh
    const FileFormat* format = nullptr; ///< null: the mesh format of the file's extension
    StockProvenance provenance = {};    ///< for a saved stock
};

struct ExportSummary {
    QString file;
    std::size_t block = 0;  ///< blocks executed when the stock was as in the file …
    std::size_t blocks = 0; ///< … and blocks in total
    bool stock = false;     ///< the z-map itself was saved, so there is no mesh and no error
    std::uint64_t triangles = 0;
    std::uint64_t bytes = 0;
    double largestErrorMm = 0;             ///< of the file's content, measured against the z-map
    double allowanceMm = 0;                ///< of the decimation; 0: every point of the z-map was written
    bool certified = false;                ///< the decimation stays within the allowance …
    ErrorLevel level = ErrorLevel::sample; ///< … where the error was measured
    bool hasWalls = false;                 ///< … it was measured away from them
    Diagnostics warnings;                  ///< about the file
};

/// Writes the stock of a frame: the surface, closed by walls and a floor, or its z-map for the next setup.
/// Any thread. Borders between regions are always the shared ones, because those of the paper leave cracks.
/// Errors, which name the file: an extension that is not a mesh format, meshes that need more than
/// `limitBytes` of memory, an unwritable file or not enough disk space (found before the work), no stock
/// left, a file that another program has changed since the export began, cancelled.
[[nodiscard]] Result<ExportSummary> exportFrame(const Frame& frame, const QString& file,
                                                const ExportOptions& options, const WorkContext& context,
                                                double limitBytes = static_cast<double>(memoryLimitBytes()));

/// Runs one export at a time on its own thread; a new one cancels the one in progress.
class ExportJob : public QObject {
    Q_OBJECT

public:
    explicit ExportJob(QObject* parent = nullptr);
    ~ExportJob() override;

    /// `done` is called on the thread that owns this object.
    void start(FramePtr frame, const QString& file, const ExportOptions& options,
               std::function<void(Result<ExportSummary>)> done);
    void cancel();

signals:
    void progressed(double done);

private:
    std::uint64_t m_generation = 0; ///< of the newest export; older ones are not reported
    UiQueue m_replies;
    std::jthread m_thread;
};

} // namespace proveout
