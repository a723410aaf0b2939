// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run/surface_memory.h"

#include <new>
#include <optional>
#include <system_error>

#include "core/base/either_stop.h"
#include "core/base/figures_argument.h"
#include "core/base/memory.h"
#include "core/base/memory_watch.h"
#include "core/decimation/regions/region_decimator.h"
#include "core/decimation/surface/decimation_findings.h"
#include "core/decimation/surface/map_memory.h"
#include "core/simulation/setup/setup_memory.h"

namespace proveout {

namespace {

/// Points between two looks: a look takes as long as decimating some hundred, and the triangles of so many
/// take less than MemoryWatch keeps in reserve.
constexpr std::size_t kPointsPerLook = 300'000;

} // namespace

void SurfaceMemory::allow(std::uint64_t bytes) {
    m_allowed = bytes;
    m_most = residentMemoryBytes() + bytes;
}

void SurfaceMemory::begin(const Setup& setup, const Grid& grid, const DecimationParameters& parameters) {
    // While regions are made ahead (PlayAhead), those that they replace still exist.
    const double ahead = static_cast<double>(grid.nx) * grid.ny * row(parameters.method).bytesPerPoint;
    m_grid = grid;
    m_outputs = simulationOutputs(setup, true);
    m_worst = memoryForecast(setup, grid, parameters, true).most + ahead;
    m_exceeded = false;
}

bool SurfaceMemory::limit(const Surface& surface, std::size_t points, const WorkContext& context,
                          const std::function<void(const WorkContext&)>& work) {
    if (m_exceeded && points > 0)
        return false;
    if (!isWatched() || (m_unseen += points) < kPointsPerLook) {
        work(context);
        return true;
    }
    m_unseen = 0;
    const std::size_t before = surface.facesMade();
    const auto isCause = [&, held = surface.facesHeld(), parameters = surface.parameters()] {
        const std::size_t faces = held + surface.facesMade() - before;
        return scheduledBytes(m_grid, parameters, m_outputs, faces) > static_cast<double>(m_allowed);
    };
    std::optional<MemoryWatch> memory;
    try {
        memory.emplace(m_most, isCause);
    } catch (const std::system_error&) { // no memory for a thread
        m_exceeded = true;
        return false;
    }
    const EitherStop either(context.stop, memory->stop());
    try {
        work({either.token(), context.progress});
        memory->look();
    } catch (const std::bad_alloc&) {
        m_exceeded = true;
        return false;
    }
    m_exceeded = memory->exceeded();
    return !m_exceeded;
}

Diagnostic SurfaceMemory::finding(const Setup& setup, const DecimationParameters& parameters) const {
    const auto allowed = static_cast<double>(m_allowed);
    const auto would =
        finestSpacing(setup.stock, allowed, meshBytesPerPoint(parameters, simulationOutputs(setup, true)));
    return diagnosticOf(
        decimation_finding::kSurfaceTooLarge,
        {figures("{}", readableBytes(allowed)), figures("{:g}", would.value_or(setup.spacing))});
}

} // namespace proveout
