// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/program/export_memory.h"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <string>
#include <utility>
#include <vector>

#include "core/base/figures_argument.h"
#include "core/base/memory.h"
#include "core/decimation/regions/region_mesh.h"
#include "core/decimation/surface/map_memory.h"
#include "core/verification/findings/window_findings.h"

namespace proveout {

namespace {

constexpr MapOutputs kOutputs{
    .schedule = false, .whole = true, .solid = true, .walls = true, .watched = true};

double worstBytes(const Grid& grid, const DecimationParameters& parameters) {
    return static_cast<double>(grid.nx) * grid.ny * meshBytesPerPoint(parameters, kOutputs);
}

/// The finest spacing with which any surface would fit beside the map that exists.
std::optional<double> fittingSpacing(const ZMapSnapshot& zmap, const DecimationParameters& parameters,
                                     double limitBytes) {
    return finestSpacing(zmap.stock(), limitBytes + zmapBytes(zmap.grid()),
                         meshBytesPerPoint(parameters, kOutputs));
}

} // namespace

ExportMemory::ExportMemory(const ZMapSnapshot& zmap, const DecimationParameters& parameters,
                           double limitBytes, const std::stop_token& stop)
    : m_zmap(zmap), m_parameters(parameters), m_limit(limitBytes),
      m_most(static_cast<double>(residentMemoryBytes()) + std::max(limitBytes, 0.0)),
      m_watch(worstBytes(zmap.grid(), parameters) <= limitBytes
                  ? std::optional<MemoryWatch>()
                  : std::optional<MemoryWatch>(std::in_place, static_cast<std::uint64_t>(m_most))),
      m_either(stop, m_watch ? m_watch->stop() : std::stop_token()) {}

Result<void> ExportMemory::check() const {
    const Grid& grid = m_zmap.grid();
    const double needed =
        static_cast<double>(grid.nx) * grid.ny * certainBytesPerPoint(m_parameters, kOutputs);
    if (needed <= m_limit)
        return {};
    std::vector<Argument> arguments{figures("{}", readableBytes(needed)),
                                    figures("{}", readableBytes(m_limit))};
    const auto would = fittingSpacing(m_zmap, m_parameters, m_limit);
    if (!would)
        return failure(window_finding::kExportNeedsTooMuchMemory, std::move(arguments));
    arguments.push_back(figures("{:g}", *would));
    return failure(window_finding::kExportNeedsCoarserGrid, std::move(arguments));
}

bool ExportMemory::isExceeded(std::size_t triangles) const {
    const auto needs = [&] {
        const double ofList = static_cast<double>(triangles * sizeof(LatticeTriangle)); // resident already
        return static_cast<double>(residentMemoryBytes()) +
               surfaceBytes(m_zmap.grid(), triangles, countOf(m_zmap.rims()), kOutputs) - ofList;
    };
    return m_watch && (m_watch->exceeded() || needs() > m_most);
}

tl::unexpected<Diagnostics> ExportMemory::tooLarge() const {
    const auto would = fittingSpacing(m_zmap, m_parameters, m_limit);
    return failure(
        window_finding::kExportSurfaceTooLarge,
        {figures("{}", readableBytes(m_limit)), figures("{:g}", would.value_or(m_zmap.grid().hx))});
}

} // namespace proveout
