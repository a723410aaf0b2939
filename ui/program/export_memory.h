// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <stop_token>

#include "core/base/diagnostic.h"
#include "core/base/either_stop.h"
#include "core/base/memory_watch.h"
#include "core/decimation/regions/parameters.h"
#include "core/zmap/zmap.h"

namespace proveout {

/// The memory that an export may take, beside the z-map that it exports. How many triangles it has is known
/// only once they are made, so they are watched; whatever is certain is checked in advance. Used by one
/// thread.
class ExportMemory {
public:
    /// `zmap` must outlive this object; `stop`: of the export.
    ExportMemory(const ZMapSnapshot& zmap, const DecimationParameters& parameters, double limitBytes,
                 const std::stop_token& stop);

    /// Refuses what cannot fit, before the work.
    [[nodiscard]] Result<void> check() const;
    /// Stopped with the export, and when the memory is used up.
    [[nodiscard]] std::stop_token stop() const { return m_either.token(); }
    /// Whether the memory is used up, or closing a surface of so many triangles would use it up.
    [[nodiscard]] bool isExceeded(std::size_t triangles) const;
    /// The refusal in that case.
    [[nodiscard]] tl::unexpected<Diagnostics> tooLarge() const;

private:
    const ZMapSnapshot& m_zmap;
    DecimationParameters m_parameters;
    double m_limit;
    double m_most;                      ///< resident, bytes
    std::optional<MemoryWatch> m_watch; ///< unless any surface fits
    EitherStop m_either;
};

} // namespace proveout
