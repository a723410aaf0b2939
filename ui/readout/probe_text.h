// SPDX-License-Identifier: GPL-3.0-or-later
// The readout of the position under the pointer, as text.
#pragma once

#include <QLocale>
#include <QString>

#include "core/verification/part/part_comparison.h"
#include "ui/readout/surface_probe.h"

namespace proveout {

/// "T3" or "T3 (assumed)" for a cut.
[[nodiscard]] QString toolText(const PlaceAnswer& answer);
/// "X 12.345 Y 3.200 Z -1.500 mm (G54)"; empty if there is no position.
[[nodiscard]] QString positionText(const SurfaceProbe& probe, const QLocale& locale);
/// "Line 120, T3"; empty if unknown.
[[nodiscard]] QString cutText(const SurfaceProbe& probe);
/// "Deviation +0.042 mm", from the part with its allowance; empty if the point is not judged, or the
/// comparison (which may be null) is not of these heights.
[[nodiscard]] QString deviationText(const SurfaceProbe& probe, const PartComparison* comparison,
                                    const QLocale& locale);

} // namespace proveout
