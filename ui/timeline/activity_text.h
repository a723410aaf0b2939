// SPDX-License-Identifier: GPL-3.0-or-later
// The activity in a range of blocks, as text.
#pragma once

#include <QString>
#include <QStringList>

#include "ui/timeline/activity_strip.h"

namespace proveout {

/// The lines of a tooltip, as rich text, with the colours of the strip: shares of the machine time, or the
/// activity of a single block, or that nothing is known yet. Empty if times are unknown.
[[nodiscard]] QStringList activityLegend(const ActivityLog& log, const ActivityStrip::Stretch& stretch,
                                         const ActivityStrip::Colors& colors);

/// One line about all blocks simulated until now; empty if there are none, or no times.
[[nodiscard]] QString activitySummary(const ActivityLog& log);

} // namespace proveout
