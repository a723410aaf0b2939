// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/cli/measured_surface.h"
#include "app/cli/mesh_outputs.h"
#include "app/cli/report.h"
#include "core/base/memory.h"
#include "core/base/work_context.h"
#include "core/decimation/surface/map_memory.h"
#include "core/formats/file_allowance.h"
#include "core/formats/job_file.h"
#include "core/simulation/run/simulation.h"

namespace proveout::cli {

/// The surface at the end of a run, and the solids that are written of it. How many triangles it has is only
/// known once it is made, so its memory is watched: too large a surface is refused with the figure and a
/// spacing that fits, and the run keeps what it has written by then.
class FinalSurface {
public:
    /// What is made, and from what.
    struct Order {
        const Job& job;
        DecimationParameters scheduled; ///< those of the simulation
        MapOutputs outputs;
        double forecastBytes;       ///< of the whole run with any surface: if it fits, nothing is watched
        CoordinateType coordinates; ///< of the files
        bool decimated;             ///< otherwise the full mesh
        bool measured;              ///< the error of the surface itself is told, not only that of the files
    };

    /// Construct it when the run begins: from then on memory counts as its own.
    FinalSurface() = default;

    /// Makes the surface of the simulation's z-map, which may have walls. False if it needs too much memory;
    /// that is reported.
    bool make(const Simulation& simulation, const ZMapSnapshot& zmap, const Order& order, Report& report);
    /// Closes the surface and writes all files of `meshes`; the same. If a file would exceed the allowance,
    /// the surface is made again for less.
    bool write(const MeshOutputs& meshes, const ZMapSnapshot& zmap, const Order& order, Report& report);

    /// Valid once it is made; its triangles are gone once it is written.
    [[nodiscard]] const SurfaceSnapshot& surface() const { return *m_surface; }
    [[nodiscard]] const MeasuredSurface& measured() const { return m_measured; }
    [[nodiscard]] const std::vector<MeshOutput>& written() const { return m_written; }
    /// The rest of the time of make() and write() went into measuring, closing and writing.
    [[nodiscard]] double decimationSeconds() const { return m_decimationSeconds; }

private:
    /// The result of `work()`, which is false if the surface needs too much memory.
    template<class Work>
    bool unlessTooLarge(const Order& order, const Grid& grid, Report& report, const Work& work);
    /// What the run may still allocate. (Asking the system again would count the threads twice.)
    [[nodiscard]] double availableBytes() const;
    /// Makes the surface by `decimate(context)`, and measures it. False if there is not enough memory.
    template<class Decimate>
    bool makeWatched(const ZMapSnapshot& zmap, const Order& order, const Decimate& decimate);

    std::uint64_t m_limitBytes = memoryLimitBytes();
    std::uint64_t m_mostBytes = residentMemoryBytes() + m_limitBytes; ///< resident
    std::optional<SurfaceSnapshot> m_surface;
    MeasuredSurface m_measured;
    std::vector<MeshOutput> m_written;
    double m_decimationSeconds = 0;
};

} // namespace proveout::cli
