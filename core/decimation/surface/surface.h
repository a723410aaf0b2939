// SPDX-License-Identifier: GPL-3.0-or-later
// The shown surface: which regions are drawn from the z-map and which have a decimated mesh (paper §3).
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/persistent_array.h"
#include "core/base/work_context.h"
#include "core/decimation/regions/region_allowances.h"
#include "core/decimation/regions/region_decimator.h"
#include "core/decimation/regions/region_set.h"
#include "core/zmap/zmap.h"

namespace proveout {

class DecimatorPool;

/// An immutable snapshot of the surface; any thread. Equal pointers of two snapshots mean equal meshes.
struct SurfaceSnapshot {
    RegionGrid grid;
    PersistentArray<RegionMeshPtr> meshes;  ///< per region; null: drawn from the z-map
    PersistentArray<BorderLinePtr> borders; ///< per border; null: drawn with all its points
    std::size_t faces = 0;                  ///< triangles shown
    std::size_t facesFull = 0;              ///< triangles without decimation
    std::size_t dirtyRegions = 0;           ///< regions drawn from the z-map

    [[nodiscard]] std::array<BorderLinePtr, 4> regionBorders(std::size_t region) const;
    /// The triangles that a region shows in this snapshot.
    [[nodiscard]] std::vector<LatticeTriangle> triangles(std::size_t region) const;
    /// The triangles of all regions, in the order of the regions.
    [[nodiscard]] std::vector<LatticeTriangle> triangles() const;
    /// The same, for a caller that needs as much memory itself: only the counts remain in the snapshot, and
    /// memory that is not shared is returned to the system.
    [[nodiscard]] std::vector<LatticeTriangle> releaseTriangles();
    /// The largest measured error of the decimated regions, mm.
    [[nodiscard]] double largestError() const;
};

/// A region's mesh and borders as its heights make them.
struct MadeRegion {
    RegionMeshPtr mesh; ///< null: not made
    std::array<BorderLinePtr, 4> borders;
};

/// The surface that follows a z-map. Owned by one thread. A border is drawn as its polyline while at least
/// one of its regions is decimated, so that there is never a crack; corners stay.
class Surface {
public:
    Surface() = default;
    /// All regions drawn from the z-map.
    Surface(int nx, int ny, const DecimationParameters& parameters);

    [[nodiscard]] const RegionGrid& grid() const { return m_state.grid; }
    [[nodiscard]] const DecimationParameters& parameters() const { return m_parameters; }

    /// Paper §3, step 2: regions with a point in `changed` are drawn from the z-map from now on. Returns how
    /// many of them were decimated before.
    std::size_t touch(const IndexRect& changed);
    /// The same for one region.
    void touchRegion(std::size_t region);
    /// Null if the region is dirty.
    [[nodiscard]] const RegionMeshPtr& mesh(std::size_t region) const { return m_state.meshes[region]; }
    [[nodiscard]] bool isDirty(std::size_t region) const { return m_state.meshes[region] == nullptr; }
    [[nodiscard]] std::size_t dirtyRegions() const { return m_state.dirtyRegions; }
    /// Ascending.
    [[nodiscard]] std::vector<std::size_t> listOfDirtyRegions() const { return m_dirty.list(); }
    [[nodiscard]] std::size_t faces() const { return m_state.faces; }
    [[nodiscard]] std::size_t facesFull() const { return m_state.facesFull; }
    /// Triangles of the decimated regions: those that need memory.
    [[nodiscard]] std::size_t facesHeld() const { return m_facesHeld; }
    /// Triangles that were made so far, by this surface and its copies; any thread, also while it decimates.
    [[nodiscard]] std::size_t facesMade() const;

    /// From now on each region has its own allowance: what a view tolerates, mm, per region, but no less than
    /// the allowance of the parameters (see RegionAllowances). Regions made with other allowances are drawn
    /// from the z-map until they are decimated again; returns them, ascending.
    std::vector<std::size_t> followView(std::span<const double> allowances);
    /// mm.
    [[nodiscard]] double allowance(std::size_t region) const { return m_allowances.region(region); }

    /// Paper §3, step 4: decimates every dirty region of `moment` (in parallel), borders first. Does nothing
    /// for method none or an allowance of 0. Returns how many regions were decimated. With a stopped context,
    /// regions that were not reached stay dirty.
    std::size_t decimateDirty(const ZMapSnapshot& moment, const WorkContext& context = {});

    /// The same for some dirty regions, ascending; the others stay unchanged.
    std::size_t decimateRegions(std::span<const std::size_t> regions, const ZMapSnapshot& moment,
                                const WorkContext& context = {});

    /// What decimateRegions() makes of one region at level `sample`, whatever the other regions show: a
    /// function of the heights. Does not change the surface; several threads may call it at once. Without a
    /// mesh if it was stopped.
    [[nodiscard]] MadeRegion make(std::size_t region, const ZMapSnapshot& moment,
                                  const std::stop_token& stop) const;
    /// decimateRegions() with what was made before for the same heights: one entry per region, each with a
    /// mesh.
    void adopt(std::span<const std::size_t> regions, std::span<MadeRegion> made);

    [[nodiscard]] SurfaceSnapshot snapshot() const { return m_state; }

private:
    /// Extra points that borders must keep, ascending.
    using ExtrasOfBorders = std::map<std::size_t, std::vector<std::uint32_t>>;
    void drawMissingBorders(std::span<const std::size_t> regions, const ZMapSnapshot& moment,
                            const ExtrasOfBorders& extras, const WorkContext& context);
    [[nodiscard]] std::vector<RegionMeshPtr> decimateBatch(std::span<const std::size_t> regions,
                                                           const ZMapSnapshot& moment,
                                                           const WorkContext& context) const;
    [[nodiscard]] std::vector<std::size_t> redraw(ExtrasOfBorders wanted, const std::set<std::size_t>& worked,
                                                  const ZMapSnapshot& moment, const WorkContext& context);
    [[nodiscard]] BorderLinePtr borderLine(std::size_t border, const ZMapSnapshot& moment,
                                           std::span<const std::uint32_t> extras) const;
    [[nodiscard]] RegionMeshPtr decimated(std::size_t region, const std::array<BorderLinePtr, 4>& borders,
                                          const ZMapSnapshot& moment, const std::stop_token& stop) const;
    void publish(std::size_t region, RegionMeshPtr mesh);
    void drawBorder(std::size_t border, BorderLinePtr line);
    void releaseBorderIfUnused(std::size_t border);
    [[nodiscard]] std::size_t facesHidden(std::size_t border) const;

    DecimationParameters m_parameters;
    RegionAllowances m_allowances;
    SurfaceSnapshot m_state;
    RegionSet m_dirty;
    std::size_t m_facesHeld = 0;
    std::shared_ptr<DecimatorPool> m_pool; ///< copies of a surface borrow from the same pool
};

} // namespace proveout
