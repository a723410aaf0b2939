// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/base/diagnostic.h"
#include "core/base/work_context.h"
#include "core/decimation/regions/parameters.h"
#include "core/formats/formats.h"
#include "core/formats/solid_export.h"

namespace proveout {

/// The allowance for which a mesh must be made, so that a file that rounds its coordinates keeps the promised
/// one. The mesh of a bounded method gets the promised allowance less the rounding; if steep walls make the
/// error of the file larger nevertheless, it is made again for less, but never for less than half. For a
/// method without a bound, and for double precision, it is the promised one. Owned by one thread:
///
///     do { make a solid for parameters(); } while (allowance.reduce(solid));
///     allowance.check(file, format.coordinates);
class FileAllowance {
public:
    /// How often a mesh is made at most; the last time for half of the promised allowance.
    static constexpr int kMostTries = 5;

    FileAllowance(const DecimationParameters& promised, CoordinateType type, const StockBox& stock);

    [[nodiscard]] const DecimationParameters& promised() const { return m_promised; }
    /// Of the file with the coarsest ones.
    [[nodiscard]] CoordinateType coordinates() const { return m_type; }
    /// For the mesh to make now.
    [[nodiscard]] const DecimationParameters& parameters() const { return m_parameters; }
    /// The part of making it, and of reduce(), in the work for all tries, most of which are not needed.
    [[nodiscard]] WorkContext thisTry(const WorkContext& whole) const;

    /// Whether a solid that was made for parameters() must be made again for less, because its file would
    /// exceed the promised allowance. A stopped context: false.
    [[nodiscard]] bool reduce(SolidForExport& solid, const WorkContext& context = {});
    /// Refuses a file for which the last solid is not within the promised allowance because of the rounding
    /// (id "export-rounding-too-large"). Call it when reduce() was false.
    [[nodiscard]] Result<void> check(const std::filesystem::path& file, CoordinateType coordinates) const;

private:
    DecimationParameters m_promised;
    DecimationParameters m_parameters;
    CoordinateType m_type;
    int m_tries = 1;
    double m_step = 0;     ///< by which the allowance was reduced last, mm
    double m_rounding = 0; ///< too large, mm; 0 if it is not
};

/// Refuses a file that no mesh of the stock can keep the allowance in, before it is made: a bounded method,
/// and rounding that takes more than half of its allowance (id "export-rounding-too-large").
[[nodiscard]] Result<void> checkRounding(const std::filesystem::path& file, CoordinateType coordinates,
                                         const DecimationParameters& promised, const StockBox& stock);

} // namespace proveout
