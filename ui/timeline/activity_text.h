// SPDX-License-Identifier: GPL-3.0-or-later
// What a stretch of the program does, in words.
#pragma once

#include <QString>
#include <QStringList>

#include "ui/timeline/activity_strip.h"

namespace proveout {

/// The lines of a tool tip, as rich text, with the colours of the strip: shares of the machine's time, or
/// what a single block does; that nothing is known yet. Empty where times are not known.
[[nodiscard]] QStringList activityLegend(const ActivityLog& log, const ActivityStrip::Stretch& stretch,
                                         const ActivityStrip::Colors& colors);

/// Of all blocks that were simulated so far, one line; empty where there are none, or no times.
[[nodiscard]] QString activitySummary(const ActivityLog& log);

} // namespace proveout
