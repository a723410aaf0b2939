// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/zmap/zmap.h"

namespace proveout {

/// The volume that a map has lost since a moment, from its heights alone: for runs without records. It is
/// summed tile by tile, in double, where the sum of a tile's heights is all but exact: a single point that
/// was lowered by a step of 1 nm counts, and a map that was not cut gives 0.
class RemovedVolume {
public:
    /// From this moment on. Reads every height; several threads inside.
    explicit RemovedVolume(const ZMap& zmap);

    /// mm³, with the weights of CutRecord, whose sum differs by rounding only. The map is that of the
    /// constructor, at a later moment. Reads every height; several threads inside.
    [[nodiscard]] double removedFrom(const ZMap& zmap) const;

private:
    std::vector<double> m_sums; ///< of heights, by tile
};

} // namespace proveout
