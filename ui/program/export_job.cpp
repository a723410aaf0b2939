// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/program/export_job.h"

#include <exception>
#include <filesystem>
#include <fmt/format.h>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/base/file_state.h"
#include "core/decimation/solid/solid.h"
#include "core/decimation/surface/refined_surface.h"
#include "core/formats/export_findings.h"
#include "core/formats/file_allowance.h"
#include "core/formats/solid_export.h"
#include "core/simulation/run/rim_finder.h"
#include "core/verification/findings/window_findings.h"
#include "ui/document/file_paths.h"
#include "ui/program/export_memory.h"

namespace proveout {

namespace {

constexpr double kWalls = 0.05; ///< of the progress
/// Progress of making a solid at the end of each step; decimation takes most of the time.
constexpr double kDecimated = 0.76;
constexpr double kClosed = 0.88;
/// Of the whole, when a solid is within the allowance, before it is written.
constexpr double kMade = 0.88;

DecimationParameters parametersOf(const Frame& frame, const ExportOptions& options) {
    DecimationParameters parameters = forExport(frame.parameters);
    if (!options.decimated)
        parameters.method = DecimationMethod::none;
    return parameters;
}

/// The map with all walls; that of a moment while something is cut has some or none. Decimation as in the
/// paper has none.
ZMapSnapshot mapToExport(const Frame& frame, const DecimationParameters& parameters,
                         const WorkContext& context) {
    ZMapSnapshot zmap = frame.zmap;
    if (!zmap.rims().empty())
        return zmap;
    zmap.setWalls({});
    const bool hasWalls =
        parameters.method == DecimationMethod::certified || parameters.method == DecimationMethod::none;
    return hasWalls ? RimFinder().find(frame, context) : zmap;
}

tl::unexpected<Diagnostics> cancelled() {
    return failure(export_finding::kCancelledWriting);
}

/// The user agreed to overwrite the content of the file at that time, which may be minutes ago.
Result<void> checkUnchanged(const QString& file, const FileState& chosen) {
    if (stateOf(toPath(file)) == chosen)
        return {};
    return failure(window_finding::kFileChangedOnDisk);
}

/// Checks before the work whether the file can be written and the disk has that many bytes of free space.
Result<void> checkTarget(const QString& file, std::uint64_t bytes) {
    return AtomicFile(toPath(file), bytes).ready();
}

Result<ExportSummary> save(const StockFormat& format, const Frame& frame, const QString& file,
                           const StockProvenance& provenance, const WorkContext& context) {
    const ZMapSnapshot zmap = mapToExport(frame, frame.parameters, context);
    if (context.stopped())
        return cancelled();
    if (auto written = format.write(toPath(file), zmap, frame.setup->spacing, provenance); !written)
        return tl::unexpected(std::move(written.error()));
    std::error_code ignored;
    const auto bytes = std::filesystem::file_size(toPath(file), ignored);
    return ExportSummary{.file = file, .stock = true, .bytes = ignored ? 0 : bytes, .warnings = {}};
}

/// Nothing if its walls cannot be drawn.
std::optional<SolidForExport> closed(ZMapSnapshot& zmap, std::vector<LatticeTriangle> triangles,
                                     const DecimationParameters& promised, CoordinateType coordinates,
                                     const WorkContext& context) {
    const ErrorLevel level = errorLevel(promised);
    if (zmap.walls().empty())
        return SolidForExport(zmap, closeSolid(zmap, std::move(triangles), context), level);
    auto walled = closeWithWalls(zmap, std::move(triangles), promised, coordinates, context);
    if (!walled)
        return std::nullopt;
    return SolidForExport(zmap, std::move(*walled), level, coordinates);
}

/// The solid for a file that keeps the allowance; it refers to `zmap`, which loses its walls if not all of
/// them can be drawn.
Result<SolidForExport> makeSolid(ZMapSnapshot& zmap, FileAllowance& allowance, const ExportMemory& memory,
                                 const WorkContext& context) {
    const WorkContext limited{memory.stop(), context.progress};
    const DecimationParameters promised = allowance.promised();
    for (;;) {
        const WorkContext part = allowance.thisTry(limited);
        SurfaceSnapshot surface = decimatedWhole(zmap, allowance.parameters(), part.part(0, kDecimated));
        if (context.stopped())
            return cancelled();
        if (memory.isExceeded(0)) // regions that are not finished have many triangles
            return memory.tooLarge();
        std::vector<LatticeTriangle> triangles = surface.releaseTriangles();
        if (memory.isExceeded(triangles.size()))
            return memory.tooLarge();
        std::optional<SolidForExport> solid = closed(zmap, std::move(triangles), promised,
                                                     allowance.coordinates(), part.part(kDecimated, kClosed));
        if (!solid) {
            zmap.setWalls({}); // and then their points are not needed
            continue;
        }
        const bool again = !limited.stopped() && allowance.reduce(*solid, part.part(kClosed, 1));
        if (context.stopped())
            return cancelled();
        if (memory.isExceeded(0))
            return memory.tooLarge();
        if (!again)
            return std::move(*solid);
    }
}

Result<ExportSummary> write(const Frame& frame, const QString& file, const ExportOptions& options,
                            const WorkContext& context, double limitBytes) {
    const Result<const FileFormat*> format =
        options.format != nullptr ? options.format : meshFormatOf(toPath(file));
    if (!format)
        return tl::unexpected(format.error());
    const FileState chosen = stateOf(toPath(file));
    const CoordinateType coordinates = (*format)->meshWriter()->coordinates;
    const DecimationParameters parameters = parametersOf(frame, options);
    const ExportMemory memory(frame.zmap, parameters, limitBytes, context.stop);
    if (Result<void> fits = memory.check(); !fits)
        return tl::unexpected(std::move(fits.error()));
    const StockBox& stock = frame.zmap.stock();
    if (Result<void> fine = checkRounding(toPath(file), coordinates, parameters, stock); !fine)
        return tl::unexpected(std::move(fine.error()));
    const std::uint64_t bytes =
        options.decimated ? 0 : fullMeshBytes(*(*format)->meshWriter(), frame.zmap.grid());
    if (Result<void> writable = checkTarget(file, bytes); !writable)
        return tl::unexpected(std::move(writable.error()));
    FileAllowance allowance(parameters, coordinates, stock);
    const WorkContext limited{memory.stop(), context.progress};
    ZMapSnapshot zmap = mapToExport(frame, parameters, limited.part(0, kWalls));
    const std::size_t wallPoints = zmap.walls().count();
    Result<SolidForExport> solid = makeSolid(zmap, allowance, memory, context.part(kWalls, kMade));
    if (!solid)
        return tl::unexpected(std::move(solid.error()));
    if (solid->mesh().triangles.empty())
        return failure(export_finding::kNothingLeft);
    solid->setWallPoints(wallPoints);
    if (Result<void> fine = allowance.check(toPath(file), coordinates); !fine)
        return tl::unexpected(std::move(fine.error()));
    if (Result<void> unchanged = checkUnchanged(file, chosen); !unchanged)
        return tl::unexpected(std::move(unchanged.error()));
    auto exported =
        exportSolid(toPath(file), *(*format)->meshWriter(), *solid, parameters, context.part(kMade, 1));
    if (!exported)
        return tl::unexpected(std::move(exported.error()));
    const bool decimates = parameters.method != DecimationMethod::none && parameters.allowance > 0;
    return ExportSummary{.file = file,
                         .triangles = exported->file.triangles,
                         .bytes = exported->file.bytes,
                         .largestErrorMm = exported->largestErrorMm,
                         .allowanceMm = decimates ? parameters.allowance : 0,
                         .certified = decimates && isBounded(parameters),
                         .level = errorLevel(parameters),
                         .hasWalls = !zmap.walls().empty(),
                         .warnings = std::move(exported->warnings)};
}

Diagnostics about(const QString& file, Diagnostics errors) {
    for (Diagnostic& error : errors)
        error.file = toPath(file).string();
    return errors;
}

} // namespace

Result<ExportSummary> exportFrame(const Frame& frame, const QString& file, const ExportOptions& options,
                                  const WorkContext& context, double limitBytes) {
    const StockFormat* stock =
        options.format == nullptr ? nullptr : std::get_if<StockFormat>(&options.format->handlers);
    const auto ofMoment = [&](Result<ExportSummary> summary) -> Result<ExportSummary> {
        if (!summary)
            return tl::unexpected(about(file, std::move(summary.error())));
        summary->block = frame.block;
        summary->blocks = frame.program ? frame.program->blockCount() : frame.block;
        return summary;
    };
    if (stock != nullptr)
        return ofMoment(save(*stock, frame, file, options.provenance, context));
    return ofMoment(write(frame, file, options, context, limitBytes));
}

ExportJob::ExportJob(QObject* parent) : QObject(parent) {}

ExportJob::~ExportJob() = default; // jthread requests a stop and joins

void ExportJob::start(FramePtr frame, const QString& file, const ExportOptions& options,
                      std::function<void(Result<ExportSummary>)> done) {
    const std::uint64_t generation = ++m_generation;
    const auto progress = [this](double fraction) {
        m_replies.post([this, fraction] { emit progressed(fraction); });
    };
    const auto finish = [this, generation, done = std::move(done)](const Result<ExportSummary>& result) {
        m_replies.post([this, generation, done, result] {
            if (generation == m_generation)
                done(result);
        });
    };
    m_thread = std::jthread(
        [frame = std::move(frame), file, options, progress, finish](const std::stop_token& stop) {
            try {
                finish(exportFrame(*frame, file, options, {stop, progress}));
            } catch (const std::exception& problem) {
                finish(failure(window_finding::kExportFailed, {problem.what()}, toPath(file).string()));
            }
        });
}

void ExportJob::cancel() {
    m_thread.request_stop();
}

} // namespace proveout
