// SPDX-License-Identifier: GPL-3.0-or-later
// What is told of the place under the pointer, in words.
#pragma once

#include <QLocale>
#include <QString>

#include "ui/readout/surface_probe.h"

namespace proveout {

/// "T3", "T3 (assumed)": of a cut.
[[nodiscard]] QString toolText(const PlaceAnswer& answer);
/// "X 12.345 Y 3.200 Z -1.500 mm (G54)"; empty where there is no place.
[[nodiscard]] QString positionText(const SurfaceProbe& probe, const QLocale& locale);
/// "Line 120, T3"; empty where that is not known.
[[nodiscard]] QString cutText(const SurfaceProbe& probe);

} // namespace proveout
