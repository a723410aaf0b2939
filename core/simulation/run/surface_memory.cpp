// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/run/surface_memory.h"

#include "core/base/either_stop.h"
#include "core/base/figures_argument.h"
#include "core/base/memory.h"
#include "core/base/memory_watch.h"
#include "core/decimation/surface/decimation_findings.h"
#include "core/decimation/surface/map_memory.h"
#include "core/simulation/setup/setup_memory.h"

namespace proveout {

namespace {

/// Regions between two looks: a look takes as long as decimating one or two, and so many take less than
/// MemoryWatch keeps in reserve.
constexpr std::size_t kRegionsPerLook = 1024;

} // namespace

void SurfaceMemory::allow(std::uint64_t bytes) {
    m_allowed = bytes;
    m_most = residentMemoryBytes() + bytes;
}

void SurfaceMemory::begin(const Setup& setup, const Grid& grid, const DecimationParameters& parameters) {
    m_worst = memoryForecast(setup, grid, parameters).most;
    m_exceeded = false;
}

bool SurfaceMemory::limit(std::size_t regions, const WorkContext& context,
                          const std::function<void(const WorkContext&)>& work) {
    if (m_exceeded && regions > 0)
        return false;
    if (m_worst <= static_cast<double>(m_allowed) || (m_unseen += regions) < kRegionsPerLook) {
        work(context);
        return true;
    }
    m_unseen = 0;
    const MemoryWatch memory(m_most);
    const EitherStop either(context.stop, memory.stop());
    work({either.token(), context.progress});
    m_exceeded = memory.exceeded();
    return !m_exceeded;
}

Diagnostic SurfaceMemory::finding(const Setup& setup, const DecimationParameters& parameters) const {
    const auto allowed = static_cast<double>(m_allowed);
    const auto would = finestSpacing(setup.stock, allowed, meshBytesPerPoint(parameters, {}));
    return diagnosticOf(
        decimation_finding::kSurfaceTooLarge,
        {figures("{}", readableBytes(allowed)), figures("{:g}", would.value_or(setup.spacing))});
}

} // namespace proveout
