// SPDX-License-Identifier: GPL-3.0-or-later
// The common interface of the decimation methods for one region.
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
/// `extras` (ascending offsets) are kept even if the rule would remove them.
struct BorderSamples {
    std::span<const float> heights;
    double step = 1;
    std::uint64_t seed = 0;
    std::span<const std::uint32_t> extras;
    std::span<const std::uint32_t> walls{}; ///< the same for points beside walls
};

/// The samples of one region. `heights` are (rect.width() × rect.height()) values, row by row, mm.
struct RegionSamples {
    IndexRect rect; ///< grid points; the global indices determine the diagonals
    double hx = 1;  ///< mm
    double hy = 1;
    std::span<const float> heights;
    /// Points beside walls, as ascending offsets: they stay vertices, because that is how walls are drawn.
    std::span<const std::uint32_t> walls{};
};

/// Border rule of the paper's method. Simplifies one border by its own samples only: distance to the line
/// through the two neighbours plus accumulated error within the allowance; with `certify`, also every sample
/// within the allowance of the polyline, vertically. `step` is the spacing along the border; `seed` decides
/// the random order. Pure function.
[[nodiscard]] BorderLine simplifyBorder(std::span<const float> heights, double step, std::uint64_t seed,
                                        const DecimationParameters& parameters);

/// Decimates regions one after the other, with storage that is allocated once and reused (paper §4.1). One
/// object per thread.
class RegionDecimator {
public:
    virtual ~RegionDecimator() = default;
    /// `borders` in the order of kSides; null entries: the method simplifies that border itself
    /// (BorderRule::paper). `seed` decides the random order. The result depends only on the arguments.
    /// Triangles are lattice indices of `grid`. After a stop it returns soon, and the result is not a valid
    /// mesh.
    [[nodiscard]] virtual RegionMesh decimate(const RegionGrid& grid, const RegionSamples& samples,
                                              const std::array<BorderLinePtr, 4>& borders, std::uint64_t seed,
                                              const DecimationParameters& parameters,
                                              const std::stop_token& stop = {}) = 0;
};

/// One row per method; panel, command line and tests read the table.
struct DecimationMethodRow {
    DecimationMethod method;
    bool wholeMap;        ///< works on one region that contains the whole map
    int defaultRegion;    ///< cells, if none is given and the map is not large: see defaultRegion()
    int defaultPeriod;    ///< blocks, if none is given
    double bytesPerPoint; ///< of its meshes and workers, in the case that nothing can be removed
    double mostPoints;    ///< of a map: the largest number that its indices can count
    std::unique_ptr<RegionDecimator> (*create)(); ///< null for `none`
    /// Simplifies a border by its own samples; a pure function, so that both its regions get the same result.
    BorderLine (*simplifyBorder)(const BorderSamples&, const DecimationParameters&);
    std::span<const std::string_view> fields; ///< keys of the parameters that it uses, except "method"

    [[nodiscard]] bool uses(std::string_view field) const;
};
[[nodiscard]] std::span<const DecimationMethodRow> decimationMethods();
[[nodiscard]] const DecimationMethodRow& row(DecimationMethod method);

/// With more regions than this, the work that every block and every frame do for each of them was measured to
/// cost more than small regions save.
inline constexpr int kMostDefaultRegions = 16'384;
inline constexpr int kLargestDefaultRegion = 128;

/// Cells along a side of a region, if none is given, on a map of `points`: the default of the method, doubled
/// up to kLargestDefaultRegion as long as there are more than kMostDefaultRegions regions.
[[nodiscard]] int defaultRegion(DecimationMethod method, double points);

/// Sets region size and period, unless given, to the defaults of the method on a map of `points`.
void useDefaults(DecimationParameters& parameters, bool regionGiven, bool periodGiven, double points);

/// Whether the allowance bounds the error at least at the z-map points.
[[nodiscard]] bool isBounded(const DecimationParameters& parameters);

/// Where the error of a surface with these parameters is measured: where it is bounded, otherwise at the
/// points.
[[nodiscard]] ErrorLevel errorLevel(const DecimationParameters& parameters);

/// Whether neighbouring meshes can be merged into one: see RefinedSurface.
[[nodiscard]] bool canMerge(const DecimationParameters& parameters);

/// The parameters for regions that are decimated again and again during cutting: the level is `sample`.
[[nodiscard]] DecimationParameters whileCutting(DecimationParameters parameters);

/// Cells along a side of a region beyond which rounding to single precision was seen to move slivers by more
/// than the allowance.
inline constexpr int kMostExportCells = 128;

/// The parameters for files: borders that cause no cracks, and no regions beyond kMostExportCells.
[[nodiscard]] DecimationParameters forExport(DecimationParameters parameters);

} // namespace proveout
