// SPDX-License-Identifier: GPL-3.0-or-later
// Which block of a program made which point of the surface.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/base/work_context.h"
#include "core/cutting/cut/provenance.h"
#include "core/nc/program/program.h"
#include "core/simulation/run/frame.h"
#include "core/simulation/setup/setup.h"

namespace proveout {

/// For each point of a map after the first `blocks` blocks: 1 + the block (0-based) that lowered the point
/// last, or Provenance::kUncut. Cuts the program a second time, from the map `uncut`, in its order; needs the
/// memory of a map and as much again: check provenanceBytes() first. Nothing if it was stopped. Any thread.
[[nodiscard]] std::optional<Provenance> blockProvenance(const ZMapSnapshot& uncut, const Program& program,
                                                        const Setup& setup, std::size_t blocks,
                                                        const WorkContext& context = {});
/// The memory needed for that, in addition to what the simulation holds.
[[nodiscard]] double provenanceBytes(const Grid& grid);

/// The one of the first `blocks` blocks that made the surface at a point of the grid, `place`, whose z is the
/// map's height there: the first that reached it, to 2 µm. Nothing if none did, or if it was stopped.
/// Evaluates every motion near the place; other motions take some 10 ns each. Any thread.
[[nodiscard]] std::optional<std::size_t> blockThatMade(const Program& program, const Setup& setup,
                                                       std::size_t blocks, const Vec3& place,
                                                       const WorkContext& context = {});

/// The same for many places at once, in parallel.
[[nodiscard]] std::vector<std::optional<std::size_t>> blocksThatMade(const Program& program,
                                                                     const Setup& setup, std::size_t blocks,
                                                                     std::span<const Vec3> places,
                                                                     const WorkContext& context = {});

/// A point of the grid of a map.
struct MapPoint {
    int i = 0;
    int j = 0;

    friend bool operator==(const MapPoint&, const MapPoint&) = default;
};

/// Whether the map of a frame is lower at a point than before the first block. Any thread.
[[nodiscard]] bool isCut(const Frame& moment, const MapPoint& point);

/// The same as above for a point of the map of a frame, which may be a detail region. Nothing also if the map
/// is as high there as before the first block, even if motions have passed along it.
[[nodiscard]] std::optional<std::size_t> blockThatMade(const Frame& moment, const MapPoint& point,
                                                       const WorkContext& context = {});

} // namespace proveout
