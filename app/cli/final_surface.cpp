// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/final_surface.h"

#include <algorithm>
#include <fmt/format.h>
#include <new>
#include <system_error>
#include <utility>

#include "core/base/memory_watch.h"
#include "core/base/stop_watch.h"
#include "core/decimation/surface/refined_surface.h"
#include "core/verification/findings/command_line_findings.h"

namespace proveout::cli {

namespace {

/// What the files must keep. A full mesh keeps every point, and nothing can be done about its rounding.
FileAllowance allowanceOf(const FinalSurface::Order& order) {
    DecimationParameters promised = order.scheduled;
    if (!order.decimated)
        promised.method = DecimationMethod::none;
    return {promised, order.coordinates, order.job.setup.stock};
}

/// Within the allowance in the files too. Otherwise the regions of the simulation are used again.
SurfaceSnapshot decimatedSurface(const Simulation& simulation, const ZMapSnapshot& zmap,
                                 const FinalSurface::Order& order, const WorkContext& context) {
    const DecimationParameters parameters = allowanceOf(order).parameters();
    return parameters == order.scheduled && zmap.walls().empty()
               ? simulation.decimatedNow(context)
               : decimatedWhole(zmap, forExport(parameters), context);
}

} // namespace

double FinalSurface::availableBytes() const {
    return std::max(0.0, static_cast<double>(m_mostBytes) - static_cast<double>(residentMemoryBytes()));
}

template<class Work>
bool FinalSurface::unlessTooLarge(const Order& order, const Grid& grid, Report& report, const Work& work) {
    const double available = availableBytes();
    try {
        if (work())
            return true;
    } catch (const std::bad_alloc&) {
        m_measured = {};
    } catch (const std::system_error&) { // no memory for another thread
        m_measured = {};
    }
    m_surface.reset();
    const auto would = finestSpacing(order.job.setup.stock, zmapBytes(grid) + available,
                                     meshBytesPerPoint(order.scheduled, order.outputs));
    report.addFatal(
        failure(command_line_finding::kSurfaceNeedsTooMuchMemory,
                {readableBytes(available), fmt::format("{:g}", would.value_or(order.job.setup.spacing))})
            .value());
    return false;
}

bool FinalSurface::make(const Simulation& simulation, const ZMapSnapshot& zmap, const Order& order,
                        Report& report) {
    const Grid& grid = zmap.grid();
    return unlessTooLarge(order, grid, report, [&] {
        return makeWatched(zmap, order, [&](const WorkContext& context) {
            return order.decimated ? decimatedSurface(simulation, zmap, order, context)
                                   : Surface(grid.nx, grid.ny, order.job.parameters).snapshot();
        });
    });
}

template<class Decimate>
bool FinalSurface::makeWatched(const ZMapSnapshot& zmap, const Order& order, const Decimate& decimate) {
    const StopWatch watch;
    const bool fits = order.forecastBytes <= static_cast<double>(m_limitBytes);
    std::optional<MemoryWatch> memory;
    if (!fits)
        memory.emplace(m_mostBytes);
    const WorkContext context{memory ? memory->stop() : std::stop_token(), {}};
    m_surface = decimate(context);
    m_decimationSeconds += watch.seconds();
    if (!fits && (memory->exceeded() || surfaceBytes(zmap.grid(), m_surface->faces, countOf(zmap.rims()),
                                                     order.outputs) > availableBytes()))
        return false;
    if (order.measured)
        m_measured = measure(*m_surface, zmap, order.job.parameters);
    return true;
}

bool FinalSurface::write(const MeshOutputs& meshes, const ZMapSnapshot& zmap, const Order& order,
                         Report& report) {
    return unlessTooLarge(order, zmap.grid(), report, [&] {
        ZMapSnapshot closed = zmap;
        const auto makeAgain = [&](const DecimationParameters& parameters) {
            return makeWatched(closed, order, [&](const WorkContext& context) {
                return decimatedWhole(closed, forExport(parameters), context);
            });
        };
        auto written = meshes.write(closed, *m_surface, allowanceOf(order), makeAgain, report);
        if (written)
            m_written = std::move(*written);
        return written.has_value();
    });
}

} // namespace proveout::cli
