// SPDX-License-Identifier: GPL-3.0-or-later
// Decimation of one region: what the methods have in common.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

#include "core/decimation/regions/parameters.h"
#include "core/decimation/regions/region_grid.h"
#include "core/decimation/regions/region_mesh.h"

namespace proveout {

/// The samples of one border. `heights` run along it, `step` mm apart; `seed` decides the random order;
/// `extras` (ascending offsets) are to be kept whatever the rule says.
struct BorderSamples {
    std::span<const float> heights;
    double step = 1;
    std::uint64_t seed = 0;
    std::span<const std::uint32_t> extras;
};

/// The samples of one region. `heights` are (rect.width() × rect.height()) values, row by row, mm.
struct RegionSamples {
    IndexRect rect; ///< grid points; global indices decide the diagonals
    double hx = 1;  ///< mm
    double hy = 1;
    std::span<const float> heights;
};

/// Border rule of the paper's method. Simplifies one border by its own samples and nothing else: distance to
/// the line through the two neighbours plus accumulated error within the allowance; with `certify`, also
/// every sample within the allowance of the polyline, vertically. `step` is the spacing along the border;
/// `seed` decides the random order. Pure function.
[[nodiscard]] BorderLine simplifyBorder(std::span<const float> heights, double step, std::uint64_t seed,
                                        const DecimationParameters& parameters);

/// Decimates regions one after the other, with storage that is allocated once and reused (paper §4.1). One
/// object a thread.
class RegionDecimator {
public:
    virtual ~RegionDecimator() = default;
    /// `borders` in the order of kSides; null entries: the method treats that border by itself
    /// (BorderRule::paper). `seed` decides the random order. The result depends on nothing but the arguments.
    /// Triangles come as lattice indices of `grid`. Stopped, it returns soon, and what it returns is no mesh.
    [[nodiscard]] virtual RegionMesh decimate(const RegionGrid& grid, const RegionSamples& samples,
                                              const std::array<BorderLinePtr, 4>& borders, std::uint64_t seed,
                                              const DecimationParameters& parameters,
                                              const std::stop_token& stop = {}) = 0;
};

/// One row a method; panel, command line and tests read the table.
struct DecimationMethodRow {
    DecimationMethod method;
    bool wholeMap;        ///< works on one region that holds the whole map
    int defaultRegion;    ///< cells, where none is given and the map is not large: see defaultRegion()
    int defaultPeriod;    ///< blocks, likewise
    double bytesPerPoint; ///< of its meshes and workers, where nothing can be removed
    double mostPoints;    ///< of a map: what its indices can count
    std::unique_ptr<RegionDecimator> (*create)(); ///< null for `none`
    /// Simplifies a border by its own samples; a pure function, so that both its regions find the same.
    BorderLine (*simplifyBorder)(const BorderSamples&, const DecimationParameters&);
    std::span<const std::string_view> fields; ///< keys of the parameters that it looks at, but for "method"

    [[nodiscard]] bool uses(std::string_view field) const;
};
[[nodiscard]] std::span<const DecimationMethodRow> decimationMethods();
[[nodiscard]] const DecimationMethodRow& row(DecimationMethod method);

/// Beyond so many regions, what every block and every frame do for each of them was measured to cost more
/// than small regions save.
inline constexpr int kMostDefaultRegions = 16'384;
inline constexpr int kLargestDefaultRegion = 128;

/// Cells along a side of a region, where none is given, on a map of `points`: the standard of the method,
/// doubled up to kLargestDefaultRegion while there were more than kMostDefaultRegions regions.
[[nodiscard]] int defaultRegion(DecimationMethod method, double points);

/// Gives region size and period the standards of the method on a map of `points`, where nobody gave them a
/// value.
void useDefaults(DecimationParameters& parameters, bool regionGiven, bool periodGiven, double points);

/// Whether the allowance is a bound of the error at least at the z-map points.
[[nodiscard]] bool isBounded(const DecimationParameters& parameters);

/// Where the error of a surface with these parameters is measured: where it is bounded, else at the points.
[[nodiscard]] ErrorLevel errorLevel(const DecimationParameters& parameters);

/// Whether neighbouring meshes can become one: see RefinedSurface.
[[nodiscard]] bool canMerge(const DecimationParameters& parameters);

/// The same while regions are decimated again and again: the level is `sample`.
[[nodiscard]] DecimationParameters whileCutting(DecimationParameters parameters);

/// Cells along a side of a region, beyond which rounding to single precision was seen to move slivers by more
/// than the allowance.
inline constexpr int kMostExportCells = 128;

/// The same for files: borders that leave no crack, and no regions beyond kMostExportCells.
[[nodiscard]] DecimationParameters forExport(DecimationParameters parameters);

} // namespace proveout
